// SPDX-License-Identifier: Apache-2.0
// Counts answers against the ground truth, grouped by the overlap of the views. Single-threaded.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/align/align_bench.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::bench {

/// a_from_b, or nothing when the method finds no pose.
using AlignAnswer = std::optional<RigidTransform>;

/// Whether an a_from_b is within kRightAngle_deg and kRightDistance_m of the truth.
[[nodiscard]] bool is_right(const RigidTransform& a_from_b, const RigidTransform& truth);

/// The reason why a pair has no answer.
enum class Unanswerable { kOtherRooms, kRoomsOfOneKind };

class AlignTally {
 public:
  void add(const AlignCase& pair, const AlignAnswer& answer);
  /// Counts a pair without a true answer: correct when the method gives none.
  void add_unanswerable(const AlignAnswer& answer, Unanswerable why);

  /// One row for each overlap class that occurs.
  [[nodiscard]] std::vector<AlignRow> rows(const std::string& input, const std::string& method,
                                           double cpu_s_per_pair) const;

 private:
  struct Class {
    AlignRow row;
    std::vector<double> rotations_deg, translations_mm;
  };
  std::map<std::string, Class> classes_;
};

/// 0 for an empty list.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace roomcast::bench
