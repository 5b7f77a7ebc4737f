// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sighting_detector.h"

#include <utility>

#include "roomcast/wire/limits.h"

namespace roomcast::sensor {
namespace {

/// Whether `interval` has passed since `last`; if so, sets `last` to `now`.
bool is_due(std::optional<RoomTime>& last, RoomTime now, nanoseconds interval) {
  if (last && now - *last < interval) return false;
  last = now;
  return true;
}

std::uint64_t wire_time(RoomTime time) {
  return static_cast<std::uint64_t>(time.time_since_epoch().count());
}

}  // namespace

void SightingDetector::stand(std::optional<alignment::CalibrationBundle> bundle) {
  bundle_ = std::move(bundle);
  heads_.reset();
  sees_floor_ = true;
  seen_.Clear();
}

std::optional<wire::pb::Sightings> SightingDetector::add(const source::CapturedFrame& frame,
                                                         RoomTime taken) {
  if (!bundle_ || !(wanted_.heads() || wanted_.tags())) return std::nullopt;
  if (!same_size(frame.depth_mm.view(), bundle_->calibration.depth)) return std::nullopt;
  if (wanted_.heads() && is_due(last_heads_, taken, kHeadInterval)) detect_heads(frame, taken);
  if (wanted_.tags() && is_due(last_tags_, taken, kTagInterval)) detect_tags(frame, taken);
  const bool seen = !seen_.heads().empty() || !seen_.tags().empty();
  if (!seen || !is_due(last_message_, taken, kSightingsMessageInterval)) return std::nullopt;
  return std::exchange(seen_, {});
}

void SightingDetector::detect_heads(const source::CapturedFrame& frame, RoomTime taken) {
  if (!heads_ && sees_floor_) {
    const auto floor = alignment::floor_of(*bundle_);
    sees_floor_ = floor.has_value();
    if (floor) heads_.emplace(*bundle_, *floor);
  }
  if (!heads_) return;
  for (const Eigen::Vector3f& head : heads_->find(frame.depth_mm.view())) {
    if (seen_.heads_size() >= wire::kMaxSightings) return;
    auto& sighting = *seen_.add_heads();
    sighting.set_room_ns(wire_time(taken));
    sighting.set_x(head.x());
    sighting.set_y(head.y());
    sighting.set_z(head.z());
  }
}

void SightingDetector::detect_tags(const source::CapturedFrame& frame, RoomTime taken) {
  if (!same_size(frame.color.view(), bundle_->calibration.color)) return;
  if (!tags_) tags_.emplace(bundle_->calibration);
  for (const alignment::SeenTag& tag : tags_->find(frame.depth_mm.view(), frame.color.view())) {
    if (seen_.tags_size() >= wire::kMaxSightings) return;
    auto& sighting = *seen_.add_tags();
    sighting.set_room_ns(wire_time(taken));
    sighting.set_tag(static_cast<std::uint32_t>(tag.id));
    for (const Eigen::Vector3d& corner : tag.corners_m) {
      for (const double metres : corner) sighting.add_corners(static_cast<float>(metres));
    }
  }
}

}  // namespace roomcast::sensor
