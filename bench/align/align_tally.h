// SPDX-License-Identifier: Apache-2.0
// Answers counted against the truth, by how much the views share. Single-threaded.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/align/align_bench.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::bench {

/// a_from_b, or that there is none.
using AlignAnswer = std::optional<RigidTransform>;

/// Why a pair has no answer.
enum class Unanswerable { kOtherRooms, kRoomsOfOneKind };

class AlignTally {
 public:
  void add(const AlignCase& pair, const AlignAnswer& answer);
  /// A pair that has no answer: right when none is given.
  void add_unanswerable(const AlignAnswer& answer, Unanswerable why);

  /// One for each class of overlap that there is.
  [[nodiscard]] std::vector<AlignRow> rows(const std::string& input, const std::string& method,
                                           double cpu_s_per_pair) const;

 private:
  struct Class {
    AlignRow row;
    std::vector<double> rotations_deg, translations_mm;
  };
  std::map<std::string, Class> classes_;
};

/// 0 of none.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace roomcast::bench
