// SPDX-License-Identifier: Apache-2.0
// Colour balance of several cameras: a factor for each camera and channel, by which the surfaces
// that two cameras both see look alike. Least squares over all pairs, with a prior that keeps the
// factors near 1. Pure; thread-safe. Source: gain compensation of panoramas (Brown and Lowe 2007),
// with logarithms of ratios.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace roomcast {

/// What two cameras share: places, and the logarithm of the colours of b over those of a, red
/// first.
struct ColorRatio {
  std::size_t a = 0, b = 0;  // cameras
  double places = 0;
  Eigen::Vector3d log_b_over_a = Eigen::Vector3d::Zero();
};

/// For each channel the logarithms of b over a, one for each place; at least one place. Reorders
/// them.
using ChannelLogs = std::array<std::vector<double>, 3>;
[[nodiscard]] ColorRatio median_ratio(std::size_t a, std::size_t b, ChannelLogs& logs);

/// Logarithms of the factors: a row for each camera, red first; 0 for a camera that shares nothing.
/// `prior_places` > 0: as many places say that the factors are 1.
[[nodiscard]] Eigen::MatrixXd log_gains(std::span<const ColorRatio> ratios, std::size_t cameras,
                                        double prior_places);

}  // namespace roomcast
