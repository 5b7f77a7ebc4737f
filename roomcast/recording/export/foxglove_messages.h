// SPDX-License-Identifier: Apache-2.0
// Messages that Foxglove, Lichtblick and Rerun recognise by name, in Protobuf, built from frames
// and clouds. Names, types and numbers of the fields are those of the published schemas
// (https://docs.foxglove.dev/docs/visualization/message-schemas). Frames: `world`, with the chosen
// axis up, and one optical frame for each sensor, of its name (x right, y down, z forward). Metres;
// depth pictures in millimetres. Times are nanoseconds since 1970-01-01 UTC. Thread-safe (no
// state).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/recording/export/point_cloud.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

/// The axis of `world` that points up. roomcast's own world has y up; robotics programs draw z up
/// (ROS REP 103). (x, y, z) of y up is (x, -z, y) of z up.
enum class UpAxis { kY, kZ };

/// The rotation into a world with that axis up, from roomcast's world.
[[nodiscard]] RigidTransform upright_from_world(UpAxis up);

enum class FoxgloveKind {
  kPoints,      // foxglove.PointCloud
  kTransform,   // foxglove.FrameTransform
  kTransforms,  // foxglove.FrameTransforms
  kVideo,       // foxglove.CompressedVideo
  kImage,       // foxglove.CompressedImage
  kDepth,       // foxglove.RawImage
  kCamera,      // foxglove.CameraCalibration
};

struct FoxgloveSchema {
  std::string name;   // "foxglove.PointCloud"
  std::string files;  // google.protobuf.FileDescriptorSet, dependencies first
};
[[nodiscard]] FoxgloveSchema foxglove_schema(FoxgloveKind kind);

/// Serialised messages. Points of `cloud` are in roomcast's world: x, y, z as float32, then blue,
/// green, red, alpha.
[[nodiscard]] std::string points_message(const PointCloud& cloud, UpAxis up, nanoseconds time);
[[nodiscard]] std::string transform_message(const std::string& sensor,
                                            const RigidTransform& world_from_depth, UpAxis up,
                                            nanoseconds time);
struct NamedPose {
  std::string sensor;
  RigidTransform world_from_depth;
};
[[nodiscard]] std::string transforms_message(std::span<const NamedPose> poses, UpAxis up,
                                             nanoseconds time);
/// One picture of a VP9 stream.
[[nodiscard]] std::string video_message(const std::string& sensor,
                                        std::span<const std::uint8_t> vp9, nanoseconds time);
[[nodiscard]] std::string jpeg_message(const std::string& sensor,
                                       std::span<const std::uint8_t> jpeg, nanoseconds time);
/// 16UC1: millimetres, 0 where there is no reading.
[[nodiscard]] std::string depth_message(const std::string& sensor, DepthView depth_mm,
                                        nanoseconds time);
/// Of the depth grid, in which colour is, too.
[[nodiscard]] std::string camera_message(const SetSensor& sensor, nanoseconds time);

}  // namespace roomcast::recording
