// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/visibility/view_culling.h"

#include <algorithm>
#include <utility>

#include "roomcast/wire/limits.h"
#include "roomcast/wire/visibility_check.h"

namespace roomcast::hub {
namespace {

/// A margin around a view; what is not told stays so.
ViewAngles widened(ViewAngles angles, double beside_rad) {
  for (double* const angle :
       {&angles.half_angle_rad, &angles.half_width_rad, &angles.half_height_rad}) {
    if (*angle > 0) *angle = std::min<double>(wire::kMaxViewHalfAngle_rad, *angle + beside_rad);
  }
  return angles;
}

}  // namespace

void ViewCulling::set_surface(SensorId sensor, SeenSurface surface) {
  SeenSurface& own = surfaces_[sensor] = std::move(surface);
  for (auto& [other, theirs] : surfaces_) {
    if (other == sensor) continue;
    link_other(sensor, &own.sight, theirs);
    link_other(other, &theirs.sight, own);
  }
  for (auto& [id, viewer] : viewers_) touch(viewer, viewer.looked_at);
}

const SeenSurface* ViewCulling::surface_of(SensorId sensor) const {
  const auto known = surfaces_.find(sensor);
  return known == surfaces_.end() ? nullptr : &known->second;
}

void ViewCulling::forget_sensor(SensorId sensor) {
  if (surfaces_.erase(sensor) == 0) return;
  for (auto& [other, theirs] : surfaces_) link_other(sensor, nullptr, theirs);
  for (auto& [id, viewer] : viewers_) touch(viewer, viewer.looked_at);
}

void ViewCulling::viewer_moved(ConnectionId id, const wire::pb::ViewerPose& pose, RoomTime now) {
  const bool wants_all = pose.view_half_angle() == 0;
  if (wants_all && !viewers_.contains(id)) return;
  Viewer& viewer = viewers_[id];
  viewer.head.moved(pose.head(), now);
  viewer.angles = {pose.view_half_angle(), pose.view_half_width(), pose.view_half_height()};
  touch(viewer, now);
}

/// The viewer is looked at in the next update() that is due.
void ViewCulling::touch(Viewer& viewer, RoomTime now) {
  viewer.has_changed = true;
  expect(std::max(now, viewer.looked_at + options_.interval));
}

void ViewCulling::expect(RoomTime time) {
  next_ = next_ ? std::min(*next_, time) : time;
}

std::vector<ViewCulling::Change> ViewCulling::update(RoomTime now) {
  std::vector<Change> changes;
  if (!next_ || now < *next_) return changes;
  next_.reset();
  for (auto& [id, viewer] : viewers_) {
    const bool is_due = viewer.has_changed && now >= viewer.looked_at + options_.interval;
    const bool is_over = viewer.revisit && now >= *viewer.revisit;
    if (is_due || is_over) {
      if (auto change = look_at(id, viewer, now)) changes.push_back(*std::move(change));
    }
    if (viewer.has_changed) expect(viewer.looked_at + options_.interval);
    if (viewer.revisit) expect(*viewer.revisit);
  }
  return changes;
}

ViewCulling::Wishes ViewCulling::wishes_for(SensorId sensor) const {
  const auto found = reduced_.find(sensor);
  const Reduced reduced = found == reduced_.end() ? Reduced() : found->second;
  return {viewers_.size() - reduced.base_only - reduced.paused, reduced.base_only};
}

/// So many viewers more get the sensor in this detail; negative: fewer.
void ViewCulling::count(SensorId sensor, Detail detail, int viewers) {
  if (detail == Detail::kAll) return;
  Reduced& reduced = reduced_[sensor];
  (detail == Detail::kBaseOnly ? reduced.base_only : reduced.paused) +=
      static_cast<std::size_t>(viewers);
}

void ViewCulling::forget_viewer(ConnectionId id) {
  const auto found = viewers_.find(id);
  if (found == viewers_.end()) return;
  for (const auto& [sensor, need] : found->second.needs) count(sensor, need.detail, -1);
  viewers_.erase(found);
}

std::optional<ViewCulling::Change> ViewCulling::look_at(ConnectionId id, Viewer& viewer,
                                                        RoomTime now) {
  viewer.has_changed = false;
  viewer.looked_at = now;
  viewer.revisit.reset();
  std::erase_if(viewer.needs, [this](const auto& need) {
    return !surfaces_.contains(need.first) && need.second.detail == Detail::kAll;
  });
  const std::vector<ViewCone> views = views_of(viewer, now);
  Change change{.viewer = id, .details = {}, .resumed = {}};
  bool has_changed = false;
  const auto settle = [&](SensorId sensor, Detail needed) {
    const auto [found, is_new] = viewer.needs.try_emplace(sensor, Need{Detail::kAll, now, now});
    const Detail before = found->second.detail;
    const Detail detail = next_detail(found->second, needed, viewer, now);
    if (detail != before) {
      has_changed = true;
      count(sensor, before, -1);
      count(sensor, detail, 1);
    }
    if (before == Detail::kPaused && detail != before) change.resumed.push_back(sensor);
    if (detail == Detail::kAll) return;
    if (change.details.size() <= sensor.value)
      change.details.resize(sensor.value + 1U, Detail::kAll);
    change.details[sensor.value] = detail;
  };
  for (const auto& [sensor, surface] : surfaces_) {
    settle(sensor, viewer.angles.half_angle_rad > 0
                       ? needed_detail(surface, views, options_.visibility)
                       : Detail::kAll);
  }
  for (auto& [sensor, need] : viewer.needs) {
    if (!surfaces_.contains(sensor)) settle(sensor, Detail::kAll);
  }
  if (!has_changed) return std::nullopt;
  return change;
}

Detail ViewCulling::next_detail(Need& need, Detail needed, Viewer& viewer, RoomTime now) const {
  if (needed == Detail::kAll) need.all = now;
  if (needed != Detail::kPaused) need.base = now;
  const auto viewers = static_cast<std::int64_t>(viewers_.size());
  const RoomTime all_ends = need.all + options_.keeps_all;
  const RoomTime base_ends = need.base + options_.keeps_base * viewers;
  const auto revisit = [&](RoomTime time) {
    viewer.revisit = viewer.revisit ? std::min(*viewer.revisit, time) : time;
  };
  if (needed == Detail::kAll || (need.detail == Detail::kAll && now < all_ends)) {
    if (needed != Detail::kAll) revisit(all_ends);
    return need.detail = Detail::kAll;
  }
  if (needed == Detail::kBaseOnly || (need.detail != Detail::kPaused && now < base_ends)) {
    if (needed == Detail::kPaused) revisit(base_ends);
    return need.detail = Detail::kBaseOnly;
  }
  return need.detail = Detail::kPaused;
}

std::vector<ViewCone> ViewCulling::cones(RoomTime now) const {
  // Nearer to another one, a cone adds nothing.
  constexpr float kSamePlace_m = 0.02F, kSameWay_rad = 0.02F;
  std::vector<ViewCone> cones;
  if (viewers_.size() > std::size_t{wire::kMaxViewCones}) return {};
  for (const auto& [id, viewer] : viewers_) {
    if (viewer.angles.half_angle_rad == 0) return {};
    const ViewAngles angles = widened(viewer.angles, options_.beside_told_rad);
    const std::size_t first = cones.size();
    for (const int halves : {0, 1, 2}) {
      const auto head = viewer.head.at(now + options_.look_ahead * halves / 2, now);
      const bool is_told = std::any_of(
          cones.begin() + static_cast<std::ptrdiff_t>(first), cones.end(), [&](const auto& cone) {
            return (cone.eye_m - head.at_m).norm() < kSamePlace_m &&
                   (cone.forward - head.forward).norm() < kSameWay_rad &&
                   (cone.up - head.up).norm() < kSameWay_rad;
          });
      if (!is_told) cones.push_back({head.at_m, head.forward, angles, head.up});
    }
  }
  return cones;
}

std::vector<ViewCone> ViewCulling::views_of(const Viewer& viewer, RoomTime now) const {
  std::vector<ViewCone> views;
  for (const auto& head : {viewer.head.now(), viewer.head.at(now + options_.look_ahead, now)})
    views.push_back({head.at_m, head.forward, viewer.angles, head.up});
  return views;
}

}  // namespace roomcast::hub
