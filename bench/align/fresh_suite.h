// SPDX-License-Identifier: Apache-2.0
// Alignment of rooms that nobody has looked at: simulated rooms of every scene, each with a seed of
// its own, whose sensors are aligned together with some of other rooms: of another room of the same
// kind, which may look alike, or of the rooms before, in turn. So about half of the pairs have no
// answer, and nothing tells the aligner which. Counts how many pairs are answered, how many of the
// answers are wrong, and whether errors are as large as expected. Single-threaded.
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
  int pairs = 1000;                 // at least so many are looked at
  std::uint64_t seed = 1;           // of the first room; each has the next
  int sensors = 5;                  // of a room
  std::size_t strangers = 2;        // of other rooms
  int frames = 3;                   // averaged for each sensor
  std::vector<std::string> scenes;  // none: all
};

/// Sensors that are aligned together: those of a room, and some that are elsewhere.
struct FreshRig {
  std::string scene;
  std::vector<SimulatedView> room, strangers;
  bool alike = false;  // the strangers are all of one other room, of the same kind
};

/// Of pairs whose views share more, in the smaller of both directions, most should be answered.
inline constexpr double kSharesEnough = 0.08;

/// Errors over what was expected of them.
struct ErrorRatios {
  std::vector<double> ratios;

  /// The share that is at most twice what was expected.
  [[nodiscard]] double within_twice() const;
};

class FreshSuite {
 public:
  void add(const FreshRig& rig);

  [[nodiscard]] int pairs() const { return pairs_; }
  [[nodiscard]] int rooms() const { return rooms_; }
  /// By overlap; "none": sensors of different rooms, "alike": of rooms of the same kind.
  [[nodiscard]] std::vector<AlignRow> rows() const;
  /// The same of each scene: of the pairs that share enough, and of those without an answer.
  [[nodiscard]] std::vector<SceneRow> scenes() const { return scenes_.rows(); }
  /// Of the pairs that share enough: how many there are, and were answered.
  [[nodiscard]] int sharing() const { return sharing_; }
  [[nodiscard]] int sharing_answered() const { return sharing_answered_; }
  /// Of the placed sensors: errors 2.5 m ahead, and of the direction, over what was expected.
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
