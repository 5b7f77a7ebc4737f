// SPDX-License-Identifier: Apache-2.0
// Pictures in ROS messages: raw (sensor_msgs/Image) with the encodings of image_encodings.h, and
// compressed (sensor_msgs/CompressedImage): JPEG, PNG, and "compressedDepth", which is PNG or RVL
// (Wilson, "Fast lossless depth image compression", 2017) after 12 bytes of settings.
// Single-threaded.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/import/pixel_formats.h"
#include "roomcast/recording/ros/messages.h"

namespace roomcast::recording {

enum class RosPictureKind { kDepth, kColor, kOther };

/// What a picture of this encoding ("16UC1", "bgr8") or compressed format ("jpeg") shows. Depth of
/// 16 bits and infrared look alike: `topic` decides.
[[nodiscard]] RosPictureKind kind_of_encoding(const std::string& encoding,
                                              const std::string& topic);
[[nodiscard]] RosPictureKind kind_of_compressed(const std::string& format);

/// Whether a compressed format is JPEG of three colours.
[[nodiscard]] bool is_jpeg(const std::string& format);

class RosPictureDecoder {
 public:
  /// `yuv422_is_yuyv`: as in RealSense recordings; ROS means UYVY.
  explicit RosPictureDecoder(bool yuv422_is_yuyv = false) : yuv422_is_yuyv_(yuv422_is_yuyv) {}

  /// `width`, `height`: of the calibration. kMalformed: damaged, or of another size; kUnsupported:
  /// another encoding. Depth values are in the recording's unit; floats become millimetres.
  [[nodiscard]] Status depth(const ros::ImageMessage& image, int width, int height,
                             DepthImage& depth);
  [[nodiscard]] Status color(const ros::ImageMessage& image, int width, int height,
                             ColorImage& color);
  [[nodiscard]] Status depth(const ros::CompressedImageMessage& image, int width, int height,
                             DepthImage& depth);
  [[nodiscard]] Status color(const ros::CompressedImageMessage& image, int width, int height,
                             ColorImage& color);

 private:
  bool yuv422_is_yuyv_;
  PictureDecoder decoder_;
};

/// Decodes RVL into `depth`, whose size is set. False: damaged.
[[nodiscard]] bool decode_rvl(std::span<const std::uint8_t> bytes, DepthImage& depth);

}  // namespace roomcast::recording
