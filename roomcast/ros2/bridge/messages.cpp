// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/bridge/messages.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <Eigen/Geometry>

#include "roomcast/recording/ros/cdr_writer.h"

namespace roomcast::ros2 {
namespace {

using recording::ros::CdrWriter;

constexpr std::size_t kFieldsBytes = 512;  // more than all fields but the pixels and points need
constexpr std::size_t kPointBytes = 16;
constexpr std::uint8_t kFloat32 = 7;  // sensor_msgs/PointField

template <class Pixel>
Bytes image(ImageView<const Pixel> picture, std::string_view encoding, std::string_view frame,
            nanoseconds time) {
  const std::size_t row_bytes = sizeof(Pixel) * static_cast<std::size_t>(picture.width);
  const std::size_t size = row_bytes * static_cast<std::size_t>(picture.height);
  CdrWriter message(size + frame.size() + kFieldsBytes);
  message.header(time, frame)
      .u32(static_cast<std::uint64_t>(picture.height))
      .u32(static_cast<std::uint64_t>(picture.width))
      .text(encoding)
      .u8(0)  // little-endian
      .u32(row_bytes)
      .u32(size);
  for (int y = 0; y < picture.height; ++y)
    message.part({reinterpret_cast<const std::uint8_t*>(picture.row(y)), row_bytes});
  return message.done();
}

/// A PointCloud2 up to its points, for the caller to fill.
std::span<std::uint8_t> begin_points(CdrWriter& message, std::size_t width, std::size_t height,
                                     std::string_view frame, nanoseconds time) {
  message.header(time, frame).u32(height).u32(width).u32(4);
  std::size_t offset = 0;
  for (const char* name : {"x", "y", "z", "rgb"}) {
    message.text(name).u32(offset).u8(kFloat32).u32(1);
    offset += sizeof(float);
  }
  message.u8(0).u32(kPointBytes).u32(kPointBytes * width);
  return message.bytes(kPointBytes * width * height);
}

void put_point(std::uint8_t* at, const Eigen::Vector3f& point_m, Rgb8 color) {
  std::memcpy(at, point_m.data(), 3 * sizeof(float));
  const std::uint8_t packed[] = {color.b, color.g, color.r, 0};
  std::memcpy(at + 3 * sizeof(float), packed, sizeof(packed));
}

}  // namespace

Bytes depth_image(DepthView depth_mm, std::string_view frame, nanoseconds time) {
  return image(depth_mm, "16UC1", frame, time);
}

Bytes color_image(ColorView color, std::string_view frame, nanoseconds time) {
  return image(color, "rgb8", frame, time);
}

Bytes camera_info(const CameraIntrinsics& camera, std::string_view frame, nanoseconds time) {
  CdrWriter message(frame.size() + kFieldsBytes);
  message.header(time, frame)
      .u32(static_cast<std::uint64_t>(camera.height))
      .u32(static_cast<std::uint64_t>(camera.width))
      .text("plumb_bob")
      .u32(5);
  const CameraIntrinsics& c = camera;
  for (const double d : {c.k1, c.k2, c.p1, c.p2, c.k3}) message.f64(d);
  for (const double k : {c.fx, 0.0, c.cx, 0.0, c.fy, c.cy, 0.0, 0.0, 1.0}) message.f64(k);
  for (const double r : {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}) message.f64(r);
  for (const double p : {c.fx, 0.0, c.cx, 0.0, 0.0, c.fy, c.cy, 0.0, 0.0, 0.0, 1.0, 0.0})
    message.f64(p);
  message.u32(0).u32(0);                      // no binning
  message.u32(0).u32(0).u32(0).u32(0).u8(0);  // the whole picture
  return message.done();
}

Bytes sensor_points(DepthView depth_mm, ColorView color, const Image<Eigen::Vector2f>& rays,
                    std::string_view frame, nanoseconds time) {
  ROOMCAST_ASSERT(depth_mm.width == rays.width() && depth_mm.height == rays.height());
  const bool has_color = same_size(color, depth_mm);
  CdrWriter message(kPointBytes * depth_mm.pixel_count() + frame.size() + kFieldsBytes);
  std::uint8_t* at = begin_points(message, static_cast<std::size_t>(depth_mm.width),
                                  static_cast<std::size_t>(depth_mm.height), frame, time)
                         .data();
  const float none = std::numeric_limits<float>::quiet_NaN();
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x, at += kPointBytes) {
      const float z =
          depth_mm.at(x, y) == 0 ? none : 0.001F * static_cast<float>(depth_mm.at(x, y));
      const Eigen::Vector2f& ray = rays.at(x, y);  // not a number where the lens has no ray
      const bool is_point = std::isfinite(z) && ray.allFinite();
      put_point(at,
                is_point ? Eigen::Vector3f(ray.x() * z, ray.y() * z, z)
                         : Eigen::Vector3f(none, none, none),
                has_color ? color.at(x, y) : Rgb8{});
    }
  }
  message.u8(0);  // some points are not numbers
  return message.done();
}

Bytes world_points(const recording::PointCloud& cloud, const RigidTransform& upright_from_world,
                   nanoseconds time) {
  CdrWriter message(kPointBytes * cloud.size() + kFieldsBytes);
  std::uint8_t* at = begin_points(message, cloud.size(), 1, kWorldFrame, time).data();
  const Eigen::Matrix3f rotation = upright_from_world.rotation.cast<float>();
  for (std::size_t i = 0; i < cloud.size(); ++i, at += kPointBytes)
    put_point(at, rotation * cloud.points_m[i], cloud.colors[i]);
  message.u8(1);  // all are numbers
  return message.done();
}

Bytes transforms(std::span<const FramePose> poses, nanoseconds time) {
  CdrWriter message(kFieldsBytes * (poses.size() + 1));
  message.u32(poses.size());
  for (const FramePose& pose : poses) {
    message.header(time, kWorldFrame).text(pose.frame);
    const Eigen::Vector3d& t = pose.world_from_frame.translation_m;
    const Eigen::Quaterniond q(pose.world_from_frame.rotation);
    for (const double v : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) message.f64(v);
  }
  return message.done();
}

}  // namespace roomcast::ros2
