// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/visibility/view_visibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace roomcast::hub {
namespace {

constexpr float kAtHand_m = 0.3F;  // nearer points are seen, wherever the viewer looks
constexpr float kPi = std::numbers::pi_v<float>;

struct Limits {
  Limits(const ViewCone& view, const VisibilityNeed& need)
      : bounds(view, need.beside_rad), facing(std::cos(std::min(kPi, need.facing_rad))) {}

  ViewBounds bounds;
  float facing;  // cosine
};

struct PreparedView {
  Limits all, base_only;
};

/// Whether another sensor looks at the point from a direction nearer to the viewer's. Of what
/// moves, this one's picture may be the newer one, and half its frames would trail behind the
/// other's.
bool is_shown_better(const SurfacePoint& point, const Eigen::Vector3f& to_viewer, float facing,
                     float better) {
  if (point.moves) return false;
  return std::ranges::any_of(point.others, [&](const OtherView& other) {
    return to_viewer.dot(other.to_sensor) > facing + better;
  });
}

Detail detail_of_point(const SurfacePoint& point, const std::vector<PreparedView>& views,
                       float better) {
  Detail detail = Detail::kPaused;
  for (const PreparedView& view : views) {
    const Eigen::Vector3f away = point.at_m - view.all.bounds.eye_m();
    const float distance = away.norm();
    if (distance < kAtHand_m) return Detail::kAll;
    const Eigen::Vector3f to_viewer = -away / distance;
    const float facing = to_viewer.dot(point.to_sensor);
    const auto is_within = [&](const Limits& limits) {
      return facing >= limits.facing && limits.bounds.distance_outside(away) <= 0;
    };
    if (is_within(view.all) && !is_shown_better(point, to_viewer, facing, better))
      return Detail::kAll;
    if (is_within(view.base_only)) detail = Detail::kBaseOnly;
  }
  return detail;
}

}  // namespace

Detail needed_detail(const SeenSurface& surface, const std::vector<ViewCone>& views,
                     const VisibilityOptions& options) {
  std::vector<PreparedView> prepared;
  prepared.reserve(views.size());
  for (const ViewCone& view : views)
    prepared.push_back({Limits(view, options.all), Limits(view, options.base_only)});
  const auto enough = [&surface](float share) {
    return std::max(1.0F, share * static_cast<float>(surface.points.size()));
  };
  const float enough_for_all = enough(options.all.enough);
  const float enough_moving = enough(options.enough_moving);
  float all = 0, moving = 0, base_only = 0;
  for (const SurfacePoint& point : surface.points) {
    const Detail detail = detail_of_point(point, prepared, options.better);
    if (detail == Detail::kAll && ++all >= enough_for_all) return Detail::kAll;
    if (detail == Detail::kAll && point.moves && ++moving >= enough_moving) return Detail::kAll;
    if (detail != Detail::kPaused) ++base_only;
  }
  return base_only >= enough(options.base_only.enough) ? Detail::kBaseOnly : Detail::kPaused;
}

}  // namespace roomcast::hub
