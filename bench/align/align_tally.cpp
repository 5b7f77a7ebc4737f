// SPDX-License-Identifier: Apache-2.0
#include "bench/align/align_tally.h"

#include <algorithm>
#include <numbers>

#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::bench {
namespace {

constexpr const char *kOtherRooms = "none", *kRoomsOfOneKind = "alike";

std::string overlap_class(double overlap) {
  if (overlap > 0.6) return ">60 %";
  if (overlap > 0.3) return "30-60 %";
  return overlap > 0.1 ? "10-30 %" : "<10 %";
}

}  // namespace

namespace {

struct FoundError {
  double angle_deg, distance_m;
  [[nodiscard]] bool is_right() const {
    return angle_deg < kRightAngle_deg && distance_m < kRightDistance_m;
  }
};

FoundError error_of(const RigidTransform& a_from_b, const RigidTransform& truth) {
  const auto error = alignment::difference(a_from_b.inverse(), truth.inverse(), {0, 0, 0});
  return {error.angle_rad * 180 / std::numbers::pi, error.distance_m};
}

}  // namespace

bool is_right(const RigidTransform& a_from_b, const RigidTransform& truth) {
  return error_of(a_from_b, truth).is_right();
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void AlignTally::add(const AlignCase& pair, const AlignAnswer& answer) {
  Class& of_overlap = classes_[overlap_class(pair.overlap)];
  ++of_overlap.row.pairs;
  if (!answer) return;
  ++of_overlap.row.accepted;
  const FoundError error = error_of(*answer, pair.a_from_b);
  const bool right = error.is_right();
  of_overlap.row.right += right;
  of_overlap.row.accepted_wrong += !right;
  if (!right) return;
  of_overlap.rotations_deg.push_back(error.angle_deg);
  of_overlap.translations_mm.push_back(1000 * error.distance_m);
}

void AlignTally::add_unanswerable(const AlignAnswer& answer, Unanswerable why) {
  AlignRow& row = classes_[why == Unanswerable::kOtherRooms ? kOtherRooms : kRoomsOfOneKind].row;
  ++row.pairs;
  row.accepted += answer.has_value();
  row.accepted_wrong += answer.has_value();
  row.right += !answer;
}

std::vector<AlignRow> AlignTally::rows(const std::string& input, const std::string& method,
                                       double cpu_s_per_pair) const {
  std::vector<AlignRow> rows;
  for (const char* overlap :
       {">60 %", "30-60 %", "10-30 %", "<10 %", kOtherRooms, kRoomsOfOneKind}) {
    const auto found = classes_.find(overlap);
    if (found == classes_.end()) continue;
    AlignRow row = found->second.row;
    row.input = input;
    row.method = method;
    row.overlap = overlap;
    row.median_rotation_deg = median(found->second.rotations_deg);
    row.median_translation_mm = median(found->second.translations_mm);
    row.cpu_s_per_pair = cpu_s_per_pair;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace roomcast::bench
