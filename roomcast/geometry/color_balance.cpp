// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/color_balance.h"

#include <algorithm>

#include "roomcast/geometry/dense_solvers.h"

namespace roomcast {
namespace {

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

ColorRatio median_ratio(std::size_t a, std::size_t b, ChannelLogs& logs) {
  ColorRatio ratio{a, b, static_cast<double>(logs[0].size())};
  for (std::size_t c = 0; c < logs.size(); ++c)
    ratio.log_b_over_a[static_cast<Eigen::Index>(c)] = median(logs[c]);
  return ratio;
}

Eigen::MatrixXd log_gains(std::span<const ColorRatio> ratios, std::size_t cameras,
                          double prior_places) {
  const auto count = static_cast<Eigen::Index>(cameras);
  Eigen::MatrixXd normal = prior_places * Eigen::MatrixXd::Identity(count, count);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, 3);
  for (const ColorRatio& ratio : ratios) {
    const auto a = static_cast<Eigen::Index>(ratio.a), b = static_cast<Eigen::Index>(ratio.b);
    // Equation: gain_a * a = gain_b * b.
    normal(a, a) += ratio.places;
    normal(b, b) += ratio.places;
    normal(a, b) -= ratio.places;
    normal(b, a) -= ratio.places;
    right.row(a) += ratio.places * ratio.log_b_over_a.transpose();
    right.row(b) -= ratio.places * ratio.log_b_over_a.transpose();
  }
  return solve_symmetric(normal, right);
}

}  // namespace roomcast
