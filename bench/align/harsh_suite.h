// SPDX-License-Identifier: Apache-2.0
// Alignment of rigs that are unkind: rooms that repeat, reflect or end beyond the sensors' range,
// seen by uncalibrated sensors with few frames (harsh_kinds.h, harsh_views.h). Each rig is aligned
// together with one sensor of another room of the same kind, which has no answer. Counts kind by
// kind how much is answered, how many answers are wrong, and whether errors are as large as said.
// Errors are of poses alone, 2.5 m ahead. Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "bench/align/align_bench.h"
#include "bench/align/harsh_kinds.h"
#include "bench/align/harsh_views.h"
#include "roomcast/alignment/rig/alignment_report.h"

namespace roomcast::bench {

struct HarshSuiteOptions {
  std::optional<HarshPart> part;   // nothing: both
  std::vector<std::string> kinds;  // rooms, sensors or names; empty: all
  int rigs = 1;                    // of each kind
  int sensors = 4;                 // of each rig
  std::uint64_t seed = 1;
};

struct HarshRig {
  std::vector<HarshView> room;
  std::vector<HarshView> strangers;  // of another room
};

/// Pairs with more true overlap, in the smaller of both directions, should be answered.
inline constexpr double kHarshSharesEnough = 0.15;

/// A larger error than wrong lenses and scales make: the next desk, half a turn, another wall. The
/// best poses that keep nominal lenses are wrong by up to 0.3 m (ADR 23).
inline constexpr double kElsewhere_mm = 500, kElsewhere_deg = 12;

struct HarshRow {
  std::string kind, part;
  int rigs = 0, refused_views = 0;         // views that alignment cannot use at all
  int pairs = 0, answered = 0, wrong = 0;  // of one room
  int elsewhere = 0;  // of the wrong ones: another place, by kElsewhere_mm or kElsewhere_deg
  int sharing = 0, sharing_answered = 0;      // of those: with more than kHarshSharesEnough
  int strangers = 0, strangers_answered = 0;  // pairs of two rooms; each answer is wrong, too
  std::vector<double> errors_mm, errors_deg;  // of answered pairs
  std::vector<double> ratios;        // of placed sensors: error over what was said, to the first
  std::vector<double> scale_errors;  // of answered pairs: of the ratio of their depth scales

  /// The share of errors that are at most twice what was said.
  [[nodiscard]] double within_twice() const;
  void add(const HarshRow& other);
};

/// Aligns the rig, with today's options, and judges the result.
[[nodiscard]] HarshRow judged(const HarshRig& rig);

[[nodiscard]] Result<std::vector<HarshRow>> run_harsh_suite(const HarshSuiteOptions& options,
                                                            const BenchProgress& progress);

/// The rows of one part together.
[[nodiscard]] HarshRow sum_of(const std::vector<HarshRow>& rows, HarshPart part);

void print_table(const std::vector<HarshRow>& rows, std::ostream& out);
void print_json(const std::vector<HarshRow>& rows, std::ostream& out);

}  // namespace roomcast::bench
