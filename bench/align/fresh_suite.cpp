// SPDX-License-Identifier: Apache-2.0
#include "bench/align/fresh_suite.h"

#include <algorithm>
#include <ctime>
#include <deque>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "roomcast/align/pair/free_space.h"
#include "roomcast/align/pair/pose_difference.h"
#include "roomcast/align/rig/rig_aligner.h"
#include "roomcast/source/simulator/scene/room.h"

namespace roomcast::bench {
namespace {

constexpr std::size_t kOverlapPoints = 4000;

/// A sensor of the rig under test.
struct Entry {
  const SimulatedView* seen;
  bool native;  // of the room
};

std::vector<Entry> entries_of(const std::vector<SimulatedView>& room,
                              const std::vector<SimulatedView>& strangers) {
  std::vector<Entry> entries;
  for (const SimulatedView& seen : room) {
    if (seen.view) entries.push_back({&seen, true});
  }
  for (const SimulatedView& seen : strangers) {
    if (seen.view) entries.push_back({&seen, false});
  }
  return entries;
}

/// Under names that tell nothing.
align::AlignmentReport aligned(const std::vector<Entry>& entries) {
  align::RigAligner aligner;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto view = std::make_shared<align::SensorView>(*entries[i].seen->view);
    view->name = "v" + std::to_string(i);
    aligner.add(std::move(view));
  }
  return aligner.solve();
}

AlignCase case_of(const Entry& a, const Entry& b) {
  AlignCase pair;
  pair.a_from_b = a.seen->world_from_depth.inverse() * b.seen->world_from_depth;
  pair.overlap = align::check_free_space(a.seen->view->surface, b.seen->view->surface,
                                         pair.a_from_b, kOverlapPoints)
                     .consistent_least;
  return pair;
}

AlignAnswer answer(const align::SensorReport& a, const align::SensorReport& b) {
  if (!a.world_from_depth || !b.world_from_depth) return std::nullopt;
  return a.world_from_depth->inverse() * *b.world_from_depth;
}

}  // namespace

void FreshSuite::add_room(const std::vector<SimulatedView>& room,
                          const std::vector<SimulatedView>& strangers) {
  const std::vector<Entry> entries = entries_of(room, strangers);
  const std::clock_t start = std::clock();
  const align::AlignmentReport report = aligned(entries);
  cpu_s_ += double(std::clock() - start) / CLOCKS_PER_SEC;
  ++rooms_;
  const Entry* origin = nullptr;  // the first that is placed
  std::size_t origin_index = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (std::size_t j = i + 1; j < entries.size(); ++j) {
      ++pairs_;
      const AlignAnswer found = answer(report.sensors[i], report.sensors[j]);
      if (!entries[i].native || !entries[j].native) {
        tally_.add_unanswerable(found);
        continue;
      }
      const AlignCase pair = case_of(entries[i], entries[j]);
      tally_.add(pair, found);
      sharing_ += pair.overlap > kSharesEnough;
      sharing_answered_ += pair.overlap > kSharesEnough && found;
    }
    if (!report.sensors[i].placed || !entries[i].native) continue;
    if (!origin) {
      origin = &entries[i];
      origin_index = i;
      continue;
    }
    const AlignAnswer found = answer(report.sensors[origin_index], report.sensors[i]);
    judge_expected(report.sensors[i], *found, case_of(*origin, entries[i]).a_from_b);
  }
}

std::vector<AlignRow> FreshSuite::rows() const {
  return tally_.rows("fresh rooms", "roomcast, whole rig", cpu_s_ / std::max(1, pairs_));
}

void FreshSuite::judge_expected(const align::SensorReport& sensor, const RigidTransform& found,
                                const RigidTransform& truth) {
  const align::PoseDifference error = align::difference(found, truth);
  const double error_mm = 1000 * error.distance_m;
  const double error_deg = error.angle_rad * 180 / std::numbers::pi;
  distance_ratios_.ratios.push_back(error_mm / std::max(0.01, sensor.expected_error_mm));
  angle_ratios_.ratios.push_back(error_deg / std::max(1e-4, sensor.expected_error_deg));
}

double ErrorRatios::within_twice() const {
  const auto within =
      std::count_if(ratios.begin(), ratios.end(), [](double ratio) { return ratio <= 2; });
  return static_cast<double>(within) / static_cast<double>(std::max<std::size_t>(1, ratios.size()));
}

Result<FreshSuite> run_fresh_suite(const FreshSuiteOptions& options,
                                   const BenchProgress& progress) {
  FreshSuite suite;
  std::deque<SimulatedView> strangers;  // the first sensors of the rooms before
  SimulatedViewsOptions room;
  room.sensors = options.sensors;
  room.frames = options.frames;
  for (std::size_t number = 0; suite.pairs() < options.pairs; ++number) {
    room.scene = sim::kSceneNames[number % sim::kSceneNames.size()];
    room.seed = options.seed + number;
    if (progress) {
      progress(fmt::format("{} of {} pairs: making room {} ({}, seed {})", suite.pairs(),
                           options.pairs, number + 1, room.scene, room.seed));
    }
    const auto views = simulate_views(room);
    if (!views) return views.error();
    if (progress) progress(fmt::format("{} of {} pairs: aligning", suite.pairs(), options.pairs));
    suite.add_room(*views, {strangers.begin(), strangers.end()});
    strangers.push_back(views->front());
    if (strangers.size() > options.strangers) strangers.pop_front();
  }
  return suite;
}

}  // namespace roomcast::bench
