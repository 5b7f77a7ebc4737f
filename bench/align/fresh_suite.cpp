// SPDX-License-Identifier: Apache-2.0
#include "bench/align/fresh_suite.h"

#include <algorithm>
#include <ctime>
#include <deque>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "bench/align/rig_entries.h"
#include "bench/align/said_error.h"
#include "roomcast/alignment/pair/free_space.h"
#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/rig/rig_aligner.h"
#include "roomcast/simulator/scene/room.h"

namespace roomcast::bench {
namespace {

constexpr std::size_t kOverlapPoints = 4000;

/// Seed offset between a room and the room of the same kind that may look alike.
constexpr std::uint64_t kAnotherRoom = 1'000'000;

using Entry = RigEntry<SimulatedView>;

AlignCase case_of(const Entry& a, const Entry& b) {
  AlignCase pair;
  pair.a_from_b = a.seen->world_from_depth.inverse() * b.seen->world_from_depth;
  pair.overlap = alignment::check_free_space(a.seen->view->surface, b.seen->view->surface,
                                             pair.a_from_b, kOverlapPoints)
                     .min_consistent;
  return pair;
}

AlignAnswer answer(const alignment::SensorReport& a, const alignment::SensorReport& b) {
  if (!a.world_from_depth || !b.world_from_depth) return std::nullopt;
  return a.world_from_depth->inverse() * *b.world_from_depth;
}

}  // namespace

void FreshSuite::add(const FreshRig& rig) {
  const std::vector<Entry> entries = entries_of(rig.room, rig.strangers);
  const std::clock_t start = std::clock();
  const alignment::AlignmentReport report = aligned_unnamed(entries);
  cpu_s_ += double(std::clock() - start) / CLOCKS_PER_SEC;
  ++rooms_;
  const Entry* origin = nullptr;  // the first placed sensor
  std::size_t origin_index = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (std::size_t j = i + 1; j < entries.size(); ++j) {
      const AlignAnswer found = answer(report.sensors[i], report.sensors[j]);
      if (entries[i].native && entries[j].native) {
        count(case_of(entries[i], entries[j]), rig.scene, found);
      } else if (entries[i].native || !rig.alike) {
        count_unanswerable(rig, found);  // not for two strangers of one room
      }
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

void FreshSuite::count(const AlignCase& pair, const std::string& scene, const AlignAnswer& found) {
  ++pairs_;
  tally_.add(pair, found);
  if (!(pair.overlap > kSharesEnough)) return;
  ++sharing_;
  sharing_answered_ += found.has_value();
  scenes_.of(scene).add(pair, found);
}

void FreshSuite::count_unanswerable(const FreshRig& rig, const AlignAnswer& found) {
  ++pairs_;
  const Unanswerable why = rig.alike ? Unanswerable::kRoomsOfOneKind : Unanswerable::kOtherRooms;
  tally_.add_unanswerable(found, why);
  scenes_.of(rig.scene).add_unanswerable(found, why);
}

std::vector<AlignRow> FreshSuite::rows() const {
  return tally_.rows("fresh rooms", "roomcast, whole rig", cpu_s_ / std::max(1, pairs_));
}

void FreshSuite::judge_expected(const alignment::SensorReport& sensor, const RigidTransform& found,
                                const RigidTransform& truth) {
  const alignment::PoseDifference error = alignment::difference(found, truth);
  const double error_mm = 1000 * error.distance_m;
  const double error_deg = error.angle_rad * 180 / std::numbers::pi;
  distance_ratios_.ratios.push_back(error_mm / std::max(0.01, sensor.expected_error_mm));
  angle_ratios_.ratios.push_back(error_deg / std::max(1e-4, sensor.expected_error_deg));
}

double ErrorRatios::within_twice() const {
  return share_within_twice(ratios);
}

namespace {

/// Makes the rigs one after the other.
class FreshRigs {
 public:
  explicit FreshRigs(const FreshSuiteOptions& options) : options_(options) {
    scenes_ = options.scenes;
    if (scenes_.empty())
      scenes_.assign(simulator::kSceneNames.begin(), simulator::kSceneNames.end());
  }

  [[nodiscard]] std::string next_name() const {
    return fmt::format("room {} ({}, seed {})", number_ + 1, scene(), seed());
  }

  Result<FreshRig> next() {
    const auto room = sensors_of(seed(), static_cast<std::size_t>(options_.sensors));
    if (!room) return room.error();
    FreshRig rig{scene(), *room, {before_.begin(), before_.end()}, has_look_alikes()};
    if (rig.alike) {
      auto elsewhere = sensors_of(seed() + kAnotherRoom, options_.strangers);
      if (!elsewhere) return elsewhere.error();
      rig.strangers = *std::move(elsewhere);
    }
    before_.push_back(room->front());
    if (before_.size() > options_.strangers) before_.pop_front();
    ++number_;
    return rig;
  }

 private:
  [[nodiscard]] const std::string& scene() const { return scenes_[number_ % scenes_.size()]; }
  [[nodiscard]] std::uint64_t seed() const { return options_.seed + number_; }
  /// True every second time that a scene is used, beginning with the first.
  [[nodiscard]] bool has_look_alikes() const { return number_ / scenes_.size() % 2 == 0; }
  [[nodiscard]] Result<std::vector<SimulatedView>> sensors_of(std::uint64_t seed,
                                                              std::size_t only_first) const {
    return simulate_views({scene(), seed, options_.sensors, options_.frames, {}, only_first});
  }

  FreshSuiteOptions options_;
  std::vector<std::string> scenes_;
  std::size_t number_ = 0;
  std::deque<SimulatedView> before_;  // the first sensors of the previous rooms
};

}  // namespace

Result<FreshSuite> run_fresh_suite(const FreshSuiteOptions& options,
                                   const BenchProgress& progress) {
  FreshSuite suite;
  FreshRigs rigs(options);
  while (suite.pairs() < options.pairs) {
    const std::string done = fmt::format("{} of {} pairs: ", suite.pairs(), options.pairs);
    if (progress) progress(done + "making " + rigs.next_name());
    const auto rig = rigs.next();
    if (!rig) return rig.error();
    if (progress) progress(done + "aligning");
    suite.add(*rig);
  }
  return suite;
}

}  // namespace roomcast::bench
