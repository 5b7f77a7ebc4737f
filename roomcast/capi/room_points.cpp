// SPDX-License-Identifier: Apache-2.0
#include "roomcast/capi/room_points.h"

#include <cmath>

#include <Eigen/Geometry>

namespace roomcast::capi {
namespace {

constexpr Rgb8 kGrey{128, 128, 128};

/// Keeps points while `out` has room, and counts all of them.
class PointSink {
 public:
  explicit PointSink(std::span<roomcast_point> out) : out_(out) {}
  void add(const Eigen::Vector3f& point_m, Rgb8 color) {
    if (count_ < out_.size()) {
      out_[count_] = {point_m.x(), point_m.y(), point_m.z(), color.r, color.g, color.b, 255};
    }
    ++count_;
  }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::span<roomcast_point> out_;
  std::size_t count_ = 0;
};

void add_points(const ReceivedSensor& received, PointSink& sink) {
  const codec::DecodedFrame& frame = *received.frame;
  const RigidTransform& world_from_depth = received.sensor->pose.world_from_depth;
  const Eigen::Matrix3f rotation = world_from_depth.rotation.cast<float>();
  const Eigen::Vector3f place_m = world_from_depth.translation_m.cast<float>();
  for (int y = 0; y < frame.depth_mm.height(); ++y) {
    for (int x = 0; x < frame.depth_mm.width(); ++x) {
      const float z_m = 0.001F * static_cast<float>(frame.depth_mm.at(x, y));
      const Eigen::Vector2f ray = received.rays->at(x, y);
      if (z_m == 0 || std::isnan(ray.x())) continue;
      sink.add(rotation * (z_m * ray.homogeneous()) + place_m,
               frame.color.empty() ? kGrey : frame.color.at(x, y));
    }
  }
}

}  // namespace

std::size_t write_points(const std::vector<ReceivedSensor>& sensors,
                         std::span<roomcast_point> out) {
  PointSink sink(out);
  for (const ReceivedSensor& received : sensors) {
    if (received.sensor->pose.is_placed()) add_points(received, sink);
  }
  return sink.count();
}

}  // namespace roomcast::capi
