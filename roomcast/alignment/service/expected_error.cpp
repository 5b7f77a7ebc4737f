// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/expected_error.h"

#include <algorithm>
#include <numbers>

#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

constexpr double kStays_m = 0.05, kStays_rad = 0.02;  // well within alignment's accepted error
constexpr double kSigmas = 3, kNegligible_m = 0.005;

}  // namespace

bool is_same_place(const RigidTransform& known, const RigidTransform& now,
                   double expected_error_mm) {
  const double expected_m =
      std::max(kNegligible_m, 0.001 * kSigmas * std::numbers::sqrt2 * expected_error_mm);
  return is_about_the_same_place(known, now) &&
         alignment::difference(known, now).distance_m < expected_m;
}

bool is_about_the_same_place(const RigidTransform& known, const RigidTransform& now) {
  const auto apart = alignment::difference(known, now);
  return apart.distance_m < kStays_m && apart.angle_rad < kStays_rad;
}

}  // namespace roomcast::alignment
