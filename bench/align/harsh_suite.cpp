// SPDX-License-Identifier: Apache-2.0
#include "bench/align/harsh_suite.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "bench/align/align_tally.h"
#include "bench/align/depth_scale_of.h"
#include "bench/align/rig_entries.h"
#include "bench/align/said_error.h"
#include "roomcast/alignment/pair/free_space.h"
#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/rig/rig_aligner.h"

namespace roomcast::bench {
namespace {

constexpr std::size_t kHarshOverlapPoints = 4000;

using HarshEntry = RigEntry<HarshView>;

/// Two sensors of one room, and what alignment says about them.
struct JudgedPair {
  const HarshView &a, &b;
  const alignment::SensorReport &of_a, &of_b;

  [[nodiscard]] RigidTransform truth() const {
    return a.world_from_depth.inverse() * b.world_from_depth;
  }
  [[nodiscard]] std::optional<RigidTransform> found() const {
    if (!of_a.world_from_depth || !of_b.world_from_depth) return std::nullopt;
    return of_a.world_from_depth->inverse() * *of_b.world_from_depth;
  }
  [[nodiscard]] double overlap() const {
    return alignment::check_free_space(*a.surface, *b.surface, truth(), kHarshOverlapPoints)
        .min_consistent;
  }
  [[nodiscard]] double scale_error() const {
    const double said = depth_scale_of(of_a) / depth_scale_of(of_b);
    return std::abs(said / (a.depth_scale / b.depth_scale) - 1);
  }
};

void count_pair(const JudgedPair& pair, HarshRow& row) {
  const bool shares = pair.overlap() > kHarshSharesEnough;
  const auto found = pair.found();
  ++row.pairs;
  row.sharing += shares;
  if (!found) return;
  ++row.answered;
  row.sharing_answered += shares;
  row.wrong += !is_right(*found, pair.truth());
  const auto error = alignment::difference(*found, pair.truth());
  row.errors_mm.push_back(1000 * error.distance_m);
  row.errors_deg.push_back(error.angle_rad * 180 / std::numbers::pi);
  row.elsewhere += row.errors_mm.back() > kElsewhere_mm || row.errors_deg.back() > kElsewhere_deg;
  row.scale_errors.push_back(pair.scale_error());
}

/// Errors of the placed sensors of the room relative to the first of them.
void judge_what_was_said(const std::vector<HarshEntry>& entries,
                         const alignment::AlignmentReport& report, HarshRow& row) {
  const auto placed = [&](std::size_t i) {
    return entries[i].native && report.sensors[i].world_from_depth;
  };
  std::size_t first = 0;
  while (first < entries.size() && !placed(first)) ++first;
  for (std::size_t i = first + 1; i < entries.size(); ++i) {
    if (!placed(i)) continue;
    const JudgedPair pair{*entries[first].seen, *entries[i].seen, report.sensors[first],
                          report.sensors[i]};
    const double error_mm = 1000 * alignment::difference(*pair.found(), pair.truth()).distance_m;
    const double said_mm = said_of(pair.of_a, pair.of_b, *pair.found(), report.scale_error);
    row.ratios.push_back(error_mm / std::max(0.01, said_mm));
  }
}

}  // namespace

double HarshRow::within_twice() const {
  return share_within_twice(ratios);
}

void HarshRow::add(const HarshRow& other) {
  rigs += other.rigs;
  refused_views += other.refused_views;
  pairs += other.pairs;
  answered += other.answered;
  wrong += other.wrong;
  elsewhere += other.elsewhere;
  sharing += other.sharing;
  sharing_answered += other.sharing_answered;
  strangers += other.strangers;
  strangers_answered += other.strangers_answered;
  const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(errors_mm, other.errors_mm);
  append(errors_deg, other.errors_deg);
  append(ratios, other.ratios);
  append(scale_errors, other.scale_errors);
}

HarshRow judged(const HarshRig& rig) {
  const std::vector<HarshEntry> entries = entries_of(rig.room, rig.strangers);
  const alignment::AlignmentReport report = aligned_unnamed(entries);
  HarshRow row;
  row.rigs = 1;
  row.refused_views = static_cast<int>(rig.room.size() + rig.strangers.size() - entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (std::size_t j = i + 1; j < entries.size(); ++j) {
      const JudgedPair pair{*entries[i].seen, *entries[j].seen, report.sensors[i],
                            report.sensors[j]};
      if (entries[i].native && entries[j].native) {
        count_pair(pair, row);
      } else if (entries[i].native) {
        ++row.strangers;
        row.strangers_answered += pair.found().has_value();
      }
    }
  }
  judge_what_was_said(entries, report, row);
  return row;
}

namespace {

/// The seed offset of the room that the stranger is from.
constexpr std::uint64_t kStrangerRoom = kHarshRigsPerKind;

Result<HarshRig> draw_rig(const HarshKind& kind, int number, int sensors) {
  const std::uint64_t seed = kind.seed + static_cast<std::uint64_t>(number);
  auto room = harsh_views({kind.room, kind.sensors, seed, sensors});
  if (!room) return room.error();
  auto strangers = harsh_views({kind.room, kind.sensors, seed + kStrangerRoom, sensors, 1});
  if (!strangers) return strangers.error();
  return HarshRig{*std::move(room), *std::move(strangers)};
}

}  // namespace

Result<std::vector<HarshRow>> run_harsh_suite(const HarshSuiteOptions& options,
                                              const BenchProgress& progress) {
  const auto kinds = chosen_kinds(harsh_kinds(options.part, options.seed), options.kinds);
  if (kinds.empty())
    return Error{ErrorCode::kInvalidArgument, "no kind of rig has such a room or sensor"};
  std::vector<HarshRow> rows;
  for (const HarshKind& kind : kinds) {
    HarshRow row;
    row.kind = kind.name();
    row.part = name_of(kind.part);
    for (int i = 0; i < options.rigs; ++i) {
      if (progress)
        progress(fmt::format("kind {} of {}: {}, rig {} of {}", rows.size() + 1, kinds.size(),
                             row.kind, i + 1, options.rigs));
      const auto rig = draw_rig(kind, i, options.sensors);
      if (!rig) return rig.error();
      row.add(judged(*rig));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

HarshRow sum_of(const std::vector<HarshRow>& rows, HarshPart part) {
  HarshRow sum;
  sum.kind = "all";
  sum.part = name_of(part);
  for (const HarshRow& row : rows) {
    if (row.part == sum.part) sum.add(row);
  }
  return sum;
}

}  // namespace roomcast::bench
