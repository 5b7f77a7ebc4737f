// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/visibility/told_views.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "roomcast/wire/limits.h"
#include "roomcast/wire/visibility_check.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

// Smaller changes are within the margins of the cones.
constexpr float kNoticeable_m = 0.02F, kNoticeable_rad = 0.02F;

/// A head may be as far away as a pose allows, and so may the sensor, on the other side.
Eigen::Vector3f within_reach(const Eigen::Vector3f& eye_m) {
  constexpr auto kFarthest_m = static_cast<float>(wire::kMaxPosition_m);
  return eye_m.cwiseMax(-kFarthest_m).cwiseMin(kFarthest_m);
}

void set_point(const Eigen::Vector3f& from, pb::Point& to) {
  to.set_x(from.x());
  to.set_y(from.y());
  to.set_z(from.z());
}

bool is_near(const pb::Point& a, const pb::Point& b, float distance) {
  return std::hypot(a.x() - b.x(), a.y() - b.y(), a.z() - b.z()) <= distance;
}

bool is_like(const pb::WatchedFrom& a, const pb::WatchedFrom& b) {
  return std::ranges::equal(
      a.cones(), b.cones(), [](const pb::ViewCone& one, const pb::ViewCone& other) {
        return is_near(one.eye(), other.eye(), kNoticeable_m) &&
               is_near(one.forward(), other.forward(), kNoticeable_rad) &&
               is_near(one.up(), other.up(), kNoticeable_rad) &&
               std::abs(one.half_angle() - other.half_angle()) <= kNoticeable_rad &&
               std::abs(one.half_width() - other.half_width()) <= kNoticeable_rad &&
               std::abs(one.half_height() - other.half_height()) <= kNoticeable_rad;
      });
}

pb::WatchedFrom in_depth_frame(const std::vector<ViewCone>& cones,
                               const RigidTransform& world_from_depth) {
  const RigidTransform depth_from_world = world_from_depth.inverse();
  const Eigen::Matrix3f rotation = depth_from_world.rotation.cast<float>();
  pb::WatchedFrom watched;
  for (const ViewCone& cone : cones) {
    pb::ViewCone& told = *watched.add_cones();
    const Eigen::Vector3f eye_m =
        rotation * cone.eye_m + depth_from_world.translation_m.cast<float>();
    set_point(within_reach(eye_m), *told.mutable_eye());
    set_point((rotation * cone.forward).normalized(), *told.mutable_forward());
    told.set_half_angle(static_cast<float>(cone.angles.half_angle_rad));
    if (cone.angles.half_width_rad == 0 && cone.angles.half_height_rad == 0) continue;
    set_point((rotation * cone.up).normalized(), *told.mutable_up());
    told.set_half_width(static_cast<float>(cone.angles.half_width_rad));
    told.set_half_height(static_cast<float>(cone.angles.half_height_rad));
  }
  return watched;
}

}  // namespace

void ToldViews::expect_change(RoomTime now) {
  if (!due_) due_ = std::max(now, updated_ + kInterval);
  settles_ = now + kSettling;
}

std::optional<RoomTime> ToldViews::next() const {
  if (due_ && settles_) return std::min(*due_, *settles_);
  return due_ ? due_ : settles_;
}

std::vector<ToldViews::News> ToldViews::update(const std::vector<ViewCone>& cones,
                                               const std::vector<ViewTaker>& takers, RoomTime now) {
  std::vector<News> news;
  const bool wants_all = cones.empty() || cones.size() > std::size_t{wire::kMaxViewCones};
  std::erase_if(told_, [&](const auto& told) {
    const bool is_taker = std::ranges::find(takers, told.first, &ViewTaker::sensor) != takers.end();
    if (!wants_all && is_taker) return false;
    news.push_back({told.first, {}});
    return true;
  });
  if (wants_all || takers.empty()) {
    due_.reset();
    settles_.reset();
    return news;
  }
  const bool is_due = next() && now >= *next();
  if (!is_due) return news;
  if (due_ && now >= *due_) due_.reset();
  if (settles_ && now >= *settles_) settles_.reset();
  updated_ = now;
  for (const ViewTaker& taker : takers) {
    pb::WatchedFrom watched = in_depth_frame(cones, taker.world_from_depth);
    pb::WatchedFrom& told = told_[taker.sensor];
    if (is_like(told, watched)) continue;
    told = watched;
    news.push_back({taker.sensor, std::move(watched)});
  }
  return news;
}

}  // namespace roomcast::hub
