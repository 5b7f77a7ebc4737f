// SPDX-License-Identifier: Apache-2.0
#include "bench/render/judged_views.h"

#include <algorithm>
#include <map>
#include <utility>

namespace roomcast::bench {
namespace {

using Truths = std::map<std::pair<int, int>, TruthView>;  // by view and instant

Result<Truths> load_truths(const std::vector<TruthViewEntry>& entries) {
  Truths truths;
  for (const TruthViewEntry& entry : entries) {
    auto truth = load(entry);
    if (!truth) return truth.error();
    truths.emplace(std::pair(entry.view, entry.instant), *std::move(truth));
  }
  return truths;
}

Result<std::vector<ColorSight>> sights_at(const TruthViewEntry& entry, RigFrames& frames) {
  std::vector<ColorSight> sights;
  for (std::size_t s = 0; s < frames.sensors().size(); ++s) {
    auto sensor = frames.truth(frames.sensors()[s], entry.frames[s]);
    if (!sensor) return sensor.error();
    sights.emplace_back(*sensor);
  }
  return sights;
}

Result<std::vector<StillBackground>> still_backgrounds(RigFrames& frames) {
  std::vector<StillBackground> backgrounds;
  for (const RigFrames::Sensor& sensor : frames.sensors()) {
    auto& background =
        backgrounds.emplace_back(sensor.recording.camera.calibration, sensor.world_from_depth);
    for (const std::uint64_t number : RigFrames::truth_numbers(sensor)) {
      const auto truth = frames.truth(sensor, number);
      if (!truth) return truth.error();
      background.add(truth->depth_mm);
    }
  }
  return backgrounds;
}

}  // namespace

Result<std::vector<JudgedView>> read_judged_views(const std::vector<TruthViewEntry>& entries,
                                                  RigFrames& frames) {
  const auto truths = load_truths(entries);
  if (!truths) return truths.error();
  const auto backgrounds = still_backgrounds(frames);
  if (!backgrounds) return backgrounds.error();
  std::map<int, std::vector<ColorSight>> sights;  // by instant
  std::vector<JudgedView> views;
  for (const TruthViewEntry& entry : entries) {
    if (!sights.contains(entry.instant)) {
      auto found = sights_at(entry, frames);
      if (!found) return found.error();
      sights.emplace(entry.instant, *std::move(found));
    }
    const auto other = std::ranges::find_if(entries, [&](const TruthViewEntry& e) {
      return e.view == entry.view && e.instant != entry.instant;
    });
    const TruthView& now = truths->at({entry.view, entry.instant});
    const TruthView& then =
        other == entries.end() ? now : truths->at({other->view, other->instant});
    views.push_back(
        {entry, now, classify(entry, now, then, sights.at(entry.instant), *backgrounds)});
  }
  return views;
}

}  // namespace roomcast::bench
