// SPDX-License-Identifier: Apache-2.0
// Alignment on simulated rooms that were not inspected before: every scene, a new seed for each
// room. The sensors of a room are aligned together with some sensors of other rooms: in turn of
// another room of the same kind, which may look alike, and of previous rooms. About half of the
// pairs therefore have no answer, and the aligner does not know which. Counts how many pairs are
// answered, how many answers are wrong, and whether errors are as large as expected.
// Single-threaded.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "bench/align/align_bench.h"
#include "bench/align/align_tally.h"
#include "bench/align/scene_tally.h"
#include "bench/align/simulated_views.h"
#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

struct FreshSuiteOptions {
  int pairs = 1000;                 // minimum number of evaluated pairs
  std::uint64_t seed = 1;           // of the first room; increases by one per room
  int sensors = 5;                  // per room
  std::size_t strangers = 2;        // from other rooms
  int frames = 3;                   // averaged per sensor
  std::vector<std::string> scenes;  // empty: all
};

/// Sensors that are aligned together: those of a room and some of other rooms.
struct FreshRig {
  std::string scene;
  std::vector<SimulatedView> room, strangers;
  bool alike = false;  // the strangers all belong to one other room of the same kind
};

/// Most pairs with a larger overlap, in the smaller of both directions, should be answered.
inline constexpr double kSharesEnough = 0.08;

/// Ratios of actual to expected errors.
struct ErrorRatios {
  std::vector<double> ratios;

  /// The share of errors that are at most twice the expected error.
  [[nodiscard]] double within_twice() const;
};

class FreshSuite {
 public:
  void add(const FreshRig& rig);

  [[nodiscard]] int pairs() const { return pairs_; }
  [[nodiscard]] int rooms() const { return rooms_; }
  /// By overlap; "none": sensors of different rooms, "alike": of rooms of the same kind.
  [[nodiscard]] std::vector<AlignRow> rows() const;
  /// The same for each scene: for the pairs that share enough and for those without an answer.
  [[nodiscard]] std::vector<SceneRow> scenes() const { return scenes_.rows(); }
  /// Number of pairs that share enough, and of those that were answered.
  [[nodiscard]] int sharing() const { return sharing_; }
  [[nodiscard]] int sharing_answered() const { return sharing_answered_; }
  /// For the placed sensors: errors 2.5 m ahead, and of the direction, divided by the expected
  /// errors.
  [[nodiscard]] const ErrorRatios& distance_ratios() const { return distance_ratios_; }
  [[nodiscard]] const ErrorRatios& angle_ratios() const { return angle_ratios_; }

 private:
  void count(const AlignCase& pair, const std::string& scene, const AlignAnswer& found);
  void count_unanswerable(const FreshRig& rig, const AlignAnswer& found);
  void judge_expected(const alignment::SensorReport& sensor, const RigidTransform& found,
                      const RigidTransform& truth);

  AlignTally tally_;
  SceneTally scenes_;
  int pairs_ = 0, rooms_ = 0, sharing_ = 0, sharing_answered_ = 0;
  ErrorRatios distance_ratios_, angle_ratios_;
  double cpu_s_ = 0;
};

/// Errors of simulate_views.
[[nodiscard]] Result<FreshSuite> run_fresh_suite(const FreshSuiteOptions& options,
                                                 const BenchProgress& progress);

void print_table(const FreshSuite& suite, std::ostream& out);
void print_json(const FreshSuite& suite, std::ostream& out);

}  // namespace roomcast::bench
