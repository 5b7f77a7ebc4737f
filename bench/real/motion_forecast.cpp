// SPDX-License-Identifier: Apache-2.0
#include "bench/real/motion_forecast.h"

#include <chrono>
#include <cmath>
#include <cstdlib>

#include "roomcast/scene_flow/scene_flow.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

constexpr nanoseconds kApart = 100ms;  // any distance: motion is carried on by the same
constexpr float kMinMoved_m = 0.015F;  // less could be noise
constexpr float kApart_s = std::chrono::duration<float>(kApart).count();

/// How often the next frame reads a place, and how often it reads something else there.
struct Readings {
  std::int64_t all = 0, off = 0;

  void compare(int expected_mm, int read_mm) {
    if (read_mm == 0) return;
    ++all;
    off += std::abs(expected_mm - read_mm) > kMotionOff_mm;
  }
  [[nodiscard]] double share_off() const {
    return all > 0 ? static_cast<double>(off) / static_cast<double>(all) : 0;
  }
};

/// The reading at a point in the sensor's frame, metres; 0: none.
int reading_at(const CameraIntrinsics& lens, DepthView frame, const Eigen::Vector3d& point_m) {
  const auto at = project(lens, point_m);
  if (!at) return 0;
  const auto x = static_cast<int>(std::lround(at->x())), y = static_cast<int>(std::lround(at->y()));
  const bool is_inside = x >= 0 && y >= 0 && x < frame.width && y < frame.height;
  return is_inside ? frame.at(x, y) : 0;
}

/// Shows all frames once, without motion between them, so that the background is known.
void learn_background(const std::vector<DepthImage>& frames, scene_flow::SceneFlow& flow) {
  for (const DepthImage& frame : frames) flow.take(frame, RoomTime{});
}

}  // namespace

MotionForecast forecast_motion(const std::string& sensor, const CameraIntrinsics& depth,
                               const std::vector<DepthImage>& frames) {
  scene_flow::SceneFlow flow(depth);
  learn_background(frames, flow);
  const Image<Eigen::Vector2f> rays = ray_table(depth);
  MotionForecast forecast{sensor};
  Readings unmoved, moved;
  RoomTime time{1s};
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    const DepthView now = frames[i], next = frames[i + 1];
    flow.take(now, time += kApart);
    for (int y = 0; y < now.height; ++y) {
      for (int x = 0; x < now.width; ++x) {
        const float z_m = 0.001F * static_cast<float>(now.at(x, y));
        const scene_flow::CellFlow& cell =
            flow.field().at(x / scene_flow::kCellPixels, y / scene_flow::kCellPixels);
        const Eigen::Vector3f by_m = kApart_s * cell.velocity;
        if (z_m == 0 || z_m >= cell.limit_m || by_m.norm() < kMinMoved_m) continue;
        if (!rays.at(x, y).allFinite()) continue;
        ++forecast.moving;
        unmoved.compare(now.at(x, y), next.at(x, y));
        const Eigen::Vector2f& ray = rays.at(x, y);
        const Eigen::Vector3f at_m = z_m * Eigen::Vector3f(ray.x(), ray.y(), 1) + by_m;
        moved.compare(static_cast<int>(std::lround(1000 * at_m.z())),
                      reading_at(depth, next, at_m.cast<double>()));
      }
    }
  }
  forecast.off_unmoved = unmoved.share_off();
  forecast.off_moved = moved.share_off();
  return forecast;
}

}  // namespace roomcast::bench
