// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/measure/static_room.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "roomcast/alignment/bundle/steady_depth.h"

namespace roomcast::recording {
namespace {

/// The frames of one sensor over which the median is taken.
struct Gathered {
  std::vector<DepthImage> depths_mm;
  std::optional<RigidTransform> world_from_depth;
  bool seen = false;
};

void gather(const FrameSet& set, std::vector<Gathered>& sensors) {
  for (const SetFrame& frame : set.frames) {
    Gathered& gathered = sensors[frame.sensor];
    const bool moved = gathered.world_from_depth && frame.world_from_depth &&
                       !gathered.world_from_depth->translation_m.isApprox(
                           frame.world_from_depth->translation_m, 1e-9);
    if (moved) gathered.depths_mm.clear();  // frames from the previous pose show another view
    gathered.seen = true;
    if (frame.world_from_depth) gathered.world_from_depth = frame.world_from_depth;
    gathered.depths_mm.push_back(frame.pictures->depth_mm);
  }
}

std::size_t sets_between(const FrameSetReader& reader) {
  double fps = 1;
  for (const SetSensor& sensor : reader.sensors()) fps = std::max(fps, sensor.fps);
  const double sets = fps * std::chrono::duration<double>(reader.length()).count();
  return std::max<std::size_t>(1, static_cast<std::size_t>(sets / kMaxStaticFrames));
}

}  // namespace

Result<std::vector<StaticSensor>> gather_static_room(
    FrameSetReader& reader, const std::function<void(std::size_t sets)>& progress) {
  const auto& sensors = reader.sensors();
  std::vector<Gathered> gathered(sensors.size());
  const std::size_t every = sets_between(reader);
  FrameSet set;
  for (std::size_t sets = 0; sets < kMaxStaticFrames;) {
    const auto more = reader.next(set);
    if (!more && sets == 0) return more.error();
    if (!more || !*more) break;
    if (set.number % every != 0) continue;
    gather(set, gathered);
    ++sets;
    if (progress) progress(sets);
  }
  const bool alone = std::ranges::count_if(gathered, &Gathered::seen) == 1;
  std::vector<StaticSensor> room;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (!gathered[i].seen || (!gathered[i].world_from_depth && !alone)) continue;
    room.push_back(
        {sensors[i].name, sensors[i].depth, gathered[i].world_from_depth.value_or(RigidTransform()),
         sensors[i].expected_error_m, alignment::steady_depth(gathered[i].depths_mm).depth_mm,
         gathered[i].depths_mm.size(), sensors[i].scale_error});
  }
  if (!room.empty()) return room;
  return Error{ErrorCode::kNotFound,
               "no sensor of this recording is placed; align a rig with roomcast align --write"};
}

}  // namespace roomcast::recording
