// SPDX-License-Identifier: Apache-2.0
#include "roomcast/scene_flow/scene_flow.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace roomcast::scene_flow {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds kMaxGap{0.25};
constexpr double kMaxShare = 0.6;
constexpr double kMaxSpeed = 5;   // m/s; hands are rarely faster
constexpr float kMaxCost = 0.8F;  // what looks like nothing in the picture before has just come
constexpr int kGrowCells = 2;
constexpr float kBehind_m = 0.15F;  // a surface's own thickness

}  // namespace

SceneFlow::SceneFlow(const CameraIntrinsics& depth)
    : lens_(depth),
      finder_(depth.width, depth.height),
      field_(cells_along(depth.width), cells_along(depth.height)) {}

void SceneFlow::take(DepthView depth_mm, RoomTime capture_time) {
  is_still_ = true;
  if (depth_mm.width != lens_.width || depth_mm.height != lens_.height) return;
  std::swap(newest_, earlier_);
  finder_.find(depth_mm, newest_);
  const Seconds passed = time_ ? capture_time - *time_ : Seconds(0);
  time_ = capture_time;
  field_.resize(newest_.width(), newest_.height());
  if (passed <= Seconds(0) || passed > kMaxGap || finder_.share() > kMaxShare) return;
  if (finder_.cell_count() > kMaxForegroundCells) return;
  find_velocities(passed.count());
  for (int i = 0; i < kGrowCells; ++i) grow();
}

/// Through the lens without its distortion, which changes a way by some percent.
void SceneFlow::find_velocities(double seconds) {
  const auto max_cells_at_1_m =
      static_cast<float>(kMaxSpeed * seconds * std::max(lens_.fx, lens_.fy) / kCellPixels);
  const Image<Displacement>& displacements = matcher_.match(newest_, earlier_, max_cells_at_1_m);
  const auto ray = [&](float x, float y) {
    const auto pixel = [](float cell) { return (cell + 0.5F) * kCellPixels - 0.5F; };
    return Eigen::Vector3f((pixel(x) - static_cast<float>(lens_.cx)) / static_cast<float>(lens_.fx),
                           (pixel(y) - static_cast<float>(lens_.cy)) / static_cast<float>(lens_.fy),
                           1);
  };
  for (int y = 0; y < newest_.height(); ++y) {
    for (int x = 0; x < newest_.width(); ++x) {
      const float z_m = 0.001F * static_cast<float>(newest_.at(x, y));
      if (z_m == 0) continue;
      const Displacement& by = displacements.at(x, y);
      if (by.cost > kMaxCost) continue;
      const auto column = static_cast<float>(x), row = static_cast<float>(y);
      const Eigen::Vector3f now = ray(column, row) * z_m;
      const Eigen::Vector3f then = ray(column + by.x, row + by.y) * (z_m + 0.001F * by.farther_mm);
      const Eigen::Vector3f velocity = (now - then) / static_cast<float>(seconds);
      if (velocity.norm() > static_cast<float>(kMaxSpeed)) continue;
      is_still_ = false;
      field_.at(x, y) = {velocity,
                         std::min(z_m + kBehind_m, 0.001F * finder_.limits_mm().at(x, y))};
    }
  }
}

/// To cells beside: what sensors lose at the rims of things is drawn, too.
void SceneFlow::grow() {
  grown_ = field_;
  for (int y = 0; y < field_.height(); ++y) {
    for (int x = 0; x < field_.width(); ++x) {
      if (field_.at(x, y).limit_m > 0) continue;
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      float limit_m = 0;
      int count = 0;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, field_.height() - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, field_.width() - 1); ++u) {
          const CellFlow& beside = field_.at(u, v);
          if (beside.limit_m == 0) continue;
          sum += beside.velocity;
          limit_m = std::max(limit_m, beside.limit_m);
          ++count;
        }
      }
      if (count == 0) continue;
      grown_.at(x, y) = {sum / static_cast<float>(count),
                         std::min(limit_m, 0.001F * finder_.limits_mm().at(x, y))};
    }
  }
  std::swap(field_, grown_);
}

}  // namespace roomcast::scene_flow
