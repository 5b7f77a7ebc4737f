// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/instant_store.h"

#include <cmath>
#include <utility>

#include "roomcast/alignment/service/instant_schedule.h"
#include "roomcast/alignment/service/picture_bytes.h"
#include "roomcast/core/depth_factor.h"

namespace roomcast::alignment {
namespace {

constexpr double kNanosecondsPerSecond = 1e9;

}  // namespace

Result<DepthInstant> instant_from_message(const wire::pb::DepthInstant& message,
                                          const CameraIntrinsics& depth_camera) {
  auto depth = picture_of_bytes(message.depth(), depth_camera.width / kInstantBlock,
                                depth_camera.height / kInstantBlock);
  if (!depth) return depth.error();
  return DepthInstant{
      static_cast<double>(message.room_ns()) / kNanosecondsPerSecond, *std::move(depth), {}};
}

Result<wire::pb::DepthInstant> message_from_instant(const DepthInstant& instant) {
  auto depth = lossless_bytes(instant.depth_mm.view());
  if (!depth) return depth.error();
  wire::pb::DepthInstant message;
  message.set_room_ns(
      static_cast<std::uint64_t>(std::llround(instant.time_s * kNanosecondsPerSecond)));
  message.set_depth(*std::move(depth));
  return message;
}

void InstantStore::add(const std::string& sensor, DepthInstant instant, double depth_scale) {
  std::deque<Entry>& entries = entries_[sensor];
  entries.push_back({std::move(instant), depth_scale});
  is_counted_ = false;
  if (entries.size() > kMaxInstants) entries.pop_front();
}

void InstantStore::forget(const std::string& sensor) {
  entries_.erase(sensor);
  shared_.clear();
  is_counted_ = false;
}

std::vector<DepthInstant> InstantStore::of(const std::string& sensor, double depth_scale) const {
  std::vector<DepthInstant> instants;
  const auto found = entries_.find(sensor);
  if (found == entries_.end()) return instants;
  for (const Entry& entry : found->second) {
    instants.push_back(entry.instant);
    if (entry.depth_scale != depth_scale)
      multiply_depth(instants.back().depth_mm.view(), depth_scale / entry.depth_scale);
  }
  mark_moving(instants);
  return instants;
}

std::size_t InstantStore::shared_moments() {
  if (std::exchange(is_counted_, true)) return shared_.size();
  std::map<long long, int> seen_by;
  for (const auto& [sensor, entries] : entries_) {
    std::set<long long> moments;
    for (const DepthInstant& instant : of(sensor, 1)) {
      if (shows_motion(instant.moving)) moments.insert(moment_of(instant.time_s));
    }
    for (const long long moment : moments) ++seen_by[moment];
  }
  for (const auto& [moment, sensors] : seen_by) {
    if (sensors > 1) shared_.insert(moment);
  }
  return shared_.size();
}

}  // namespace roomcast::alignment
