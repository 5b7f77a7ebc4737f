// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/moving_consistency.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace roomcast::alignment {
namespace {

enum class SeenThere { kNothing, kSame, kThrough };

/// What `lens` saw at an instant where there is a point (in its frame).
SeenThere seen_at(const Lens& lens, float focal_px, const DepthInstant& instant,
                  const Eigen::Vector3f& point, const MovingConsistencyOptions& options) {
  Eigen::Vector2f pixel;
  if (!lens.project(point, pixel)) return SeenThere::kNothing;
  const int u = static_cast<int>(std::floor(pixel.x() / kInstantBlock));
  const int v = static_cast<int>(std::floor(pixel.y() / kInstantBlock));
  const int reach = std::clamp(
      static_cast<int>(std::lround(options.reach_m * focal_px / point.z() / kInstantBlock)), 1,
      options.max_reach_blocks);
  const DepthImage& depth = instant.depth_mm;
  if (u - reach < 0 || v - reach < 0 || u + reach >= depth.width() || v + reach >= depth.height())
    return SeenThere::kNothing;
  int seen = 0, nearer = 0;
  for (int y = v - reach; y <= v + reach; ++y) {
    for (int x = u - reach; x <= u + reach; ++x) {
      const float z = 0.001F * static_cast<float>(depth.at(x, y));
      if (!(z > 0)) continue;
      ++seen;
      if (instant.moving.at(x, y) != 0 && std::abs(z - point.z()) < options.same_thing_m)
        return SeenThere::kSame;
      nearer += z < point.z() + options.behind_m;
    }
  }
  const int side = 2 * reach + 1;
  const bool looked =
      static_cast<float>(seen) >= options.min_seen * static_cast<float>(side * side);
  return looked && nearer == 0 && depth.at(u, v) != 0 ? SeenThere::kThrough : SeenThere::kNothing;
}

Eigen::Vector3f point_of(const SensorView& view, const DepthInstant& instant, int x, int y) {
  return 0.001F * static_cast<float>(instant.depth_mm.at(x, y)) *
         view.block_rays.at(x, y).homogeneous();
}

std::size_t moving_blocks(const DepthInstant& instant) {
  const auto mask = instant.moving.view();
  return static_cast<std::size_t>(std::count(mask.data, mask.data + mask.pixel_count(), 255));
}

void count(const SensorView& source, const SensorView& target,
           const RigidTransform& target_from_source, const MovingConsistencyOptions& options,
           MovingConsistency& sum) {
  const Eigen::Matrix3f rotation = target_from_source.rotation.cast<float>();
  const Eigen::Vector3f shift = target_from_source.translation_m.cast<float>();
  const auto focal_px = static_cast<float>(target.surface.camera.fx);
  for (const DepthInstant& instant : source.instants) {
    const DepthInstant* const other =
        instant_at(target.instants, instant.time_s, options.max_apart_s);
    if (!other) continue;
    const MaskImage& moving = instant.moving;
    const std::size_t blocks = moving_blocks(instant);
    if (blocks < options.min_blocks) continue;
    if (moving_blocks(*other) >= options.min_blocks)
      sum.possible += static_cast<double>(std::min(options.points, blocks));
    const std::size_t step = std::max<std::size_t>(1, blocks / options.points);
    std::size_t number = 0;
    for (int y = 0; y < moving.height(); ++y) {
      for (int x = 0; x < moving.width(); ++x) {
        if (moving.at(x, y) == 0 || number++ % step != 0) continue;
        const Eigen::Vector3f point = point_of(source, instant, x, y);
        if (point.hasNaN()) continue;
        const SeenThere there =
            seen_at(target.surface.lens, focal_px, *other, rotation * point + shift, options);
        sum.consistent += there == SeenThere::kSame;
        sum.violating += there == SeenThere::kThrough;
      }
    }
  }
}

}  // namespace

const DepthInstant* instant_at(std::span<const DepthInstant> instants, double time_s,
                               double max_apart_s) {
  const DepthInstant* nearest = nullptr;
  for (const DepthInstant& each : instants) {
    const double apart_s = std::abs(each.time_s - time_s);
    if (apart_s <= max_apart_s && (!nearest || apart_s < std::abs(nearest->time_s - time_s)))
      nearest = &each;
  }
  return nearest;
}

MovingConsistency check_moving(const SensorView& a, const SensorView& b,
                               const RigidTransform& a_from_b,
                               const MovingConsistencyOptions& options) {
  MovingConsistency sum;
  count(b, a, a_from_b, options, sum);
  count(a, b, a_from_b.inverse(), options, sum);
  return sum;
}

}  // namespace roomcast::alignment
