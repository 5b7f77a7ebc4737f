// SPDX-License-Identifier: Apache-2.0
#include "bench/align/said_error.h"

#include <algorithm>
#include <cmath>

namespace roomcast::bench {

double said_of(const alignment::SensorReport& a, const alignment::SensorReport& b,
               const RigidTransform& a_from_b, double scale_error) {
  const Eigen::Vector3d ahead_m(0, 0, 2.5);  // where views usually have something
  const double by_scale_mm = 1000 * scale_error * (a_from_b * ahead_m).norm();
  return std::hypot(std::hypot(a.expected_error_mm, b.expected_error_mm), by_scale_mm);
}

double share_within_twice(std::span<const double> errors_over_said) {
  const auto within =
      std::ranges::count_if(errors_over_said, [](double ratio) { return ratio <= 2; });
  return static_cast<double>(within) /
         static_cast<double>(std::max<std::size_t>(1, errors_over_said.size()));
}

}  // namespace roomcast::bench
