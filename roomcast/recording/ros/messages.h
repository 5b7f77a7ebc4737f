// SPDX-License-Identifier: Apache-2.0
// The ROS messages of RGB-D cameras, read from either serialisation: Image, CompressedImage and
// CameraInfo of sensor_msgs, TFMessage of tf2_msgs, Transform of geometry_msgs. Fields after those
// that are needed are not read. Thread-safe (no state).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "roomcast/recording/ros/message_reader.h"

namespace roomcast::recording::ros {

using ByteView = std::span<const std::uint8_t>;

inline constexpr std::size_t kMaxLensTerms = 64, kMaxTransforms = 4096;

struct ImageMessage {
  MessageReader::Header header;
  std::uint32_t width = 0, height = 0;
  std::string encoding;  // "16UC1"
  bool is_bigendian = false;
  std::uint32_t step = 0;  // bytes of a row
  ByteView data;           // in the message
};

struct CompressedImageMessage {
  MessageReader::Header header;
  std::string format;  // "jpeg", "rgb8; jpeg compressed bgr8", "16UC1; compressedDepth png"
  ByteView data;
};

struct CameraInfoMessage {
  MessageReader::Header header;
  std::uint32_t width = 0, height = 0;
  std::string distortion_model;
  std::vector<double> d;       // lens terms
  std::array<double, 9> k{};   // of the picture as taken, row by row: fx 0 cx, 0 fy cy, 0 0 1
  std::array<double, 12> p{};  // of the rectified picture: fx 0 cx .., 0 fy cy .., 0 0 1 ..
};

struct TransformMessage {
  std::array<double, 3> translation{};
  std::array<double, 4> rotation_xyzw{};
};

struct StampedTransform {
  std::string parent, child;
  TransformMessage parent_from_child;
};

/// "Frame Timestamp", "360815089": of diagnostic_msgs.
struct KeyValueMessage {
  std::string key, value;
};

/// Nothing if the message is damaged.
[[nodiscard]] std::optional<ImageMessage> read_image(ByteView message, Serialisation from);
[[nodiscard]] std::optional<CompressedImageMessage> read_compressed_image(ByteView message,
                                                                          Serialisation from);
[[nodiscard]] std::optional<CameraInfoMessage> read_camera_info(ByteView message,
                                                                Serialisation from);
[[nodiscard]] std::optional<KeyValueMessage> read_key_value(ByteView message, Serialisation from);
[[nodiscard]] std::optional<TransformMessage> read_transform(ByteView message, Serialisation from);
[[nodiscard]] std::optional<std::vector<StampedTransform>> read_transforms(ByteView message,
                                                                           Serialisation from);

}  // namespace roomcast::recording::ros
