// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/color_gains.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <Eigen/Dense>

namespace roomcast::model {
namespace {

constexpr std::size_t kMaxPoints = 60'000;
constexpr float kMinQualityShare = 0.2F;                // of the better of two views
constexpr float kDarkest = 16, kBrightest = 240;        // levels beyond are clipped, or noise
constexpr std::size_t kMinShared = 200;                 // of a pair of views
constexpr double kPrior = 1e-3;                         // of a gain of 1, beside all that is shared

using Pair = std::pair<std::size_t, std::size_t>;

bool is_exposed(float level) {
  return level >= kDarkest && level <= kBrightest;
}

void add_shared(std::span<const ViewSurface> views, const Eigen::Vector3f& at_m, float tolerance_m,
                std::vector<SharedColor>& shared) {
  struct Seen {
    std::size_t view;
    ViewSurface::Colored colored;
  };
  std::vector<Seen> all;
  for (std::size_t i = 0; i < views.size(); ++i)
    if (const auto colored = views[i].color(at_m, tolerance_m)) all.push_back({i, *colored});
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      const float qa = all[a].colored.quality, qb = all[b].colored.quality;
      if (std::min(qa, qb) < kMinQualityShare * std::max(qa, qb)) continue;
      shared.push_back(
          {all[a].view, all[b].view, at_m, all[a].colored.color, all[b].colored.color});
    }
  }
}

/// How much brighter a is than b, in a channel; as a logarithm.
struct Ratio {
  Pair views;
  double log_ratio = 0;
  std::size_t count = 0;
};

std::vector<Ratio> ratios(std::span<const SharedColor> shared, int channel) {
  std::map<Pair, std::vector<double>> of_pair;
  for (const SharedColor& place : shared) {
    const float a = place.color_a[channel], b = place.color_b[channel];
    if (is_exposed(a) && is_exposed(b))
      of_pair[{place.view_a, place.view_b}].push_back(std::log(static_cast<double>(a / b)));
  }
  std::vector<Ratio> ratios;
  for (auto& [pair, values] : of_pair) {
    if (values.size() < kMinShared) continue;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    ratios.push_back({pair, *middle, values.size()});
  }
  return ratios;
}

/// Least squares: log_gain(a) + log_ratio = log_gain(b), weighted by what is shared.
Eigen::VectorXd log_gains(const std::vector<Ratio>& ratios, std::size_t view_count) {
  const auto n = static_cast<Eigen::Index>(view_count);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  double total = 0;
  for (const Ratio& ratio : ratios) {
    const auto a = static_cast<Eigen::Index>(ratio.views.first);
    const auto b = static_cast<Eigen::Index>(ratio.views.second);
    const auto weight = static_cast<double>(ratio.count);
    normal(a, a) += weight;
    normal(b, b) += weight;
    normal(a, b) -= weight;
    normal(b, a) -= weight;
    right(a) -= weight * ratio.log_ratio;
    right(b) += weight * ratio.log_ratio;
    total += weight;
  }
  normal.diagonal().array() += kPrior * std::max(total, 1.0);
  return normal.ldlt().solve(right);
}

}  // namespace

std::vector<SharedColor> shared_colors(std::span<const ViewSurface> views,
                                       const ModelOptions& options, const Workers& workers,
                                       const RoomMesh& mesh) {
  constexpr std::size_t kAtATime = 1024;
  const std::size_t step = std::max<std::size_t>(1, mesh.points_m.size() / kMaxPoints);
  const std::size_t count = mesh.points_m.size() / step;
  const float tolerance_m = options.truncation_voxels * options.voxel_m;
  const auto rows = static_cast<int>((count + kAtATime - 1) / kAtATime);
  std::vector<std::vector<SharedColor>> parts(static_cast<std::size_t>(rows));
  for_each_row(rows, workers, [&](int row) {
    const std::size_t begin = static_cast<std::size_t>(row) * kAtATime;
    for (std::size_t i = begin; i < std::min(begin + kAtATime, count); ++i)
      add_shared(views, mesh.points_m[i * step], tolerance_m, parts[static_cast<std::size_t>(row)]);
  });
  std::vector<SharedColor> shared;
  for (const auto& part : parts) shared.insert(shared.end(), part.begin(), part.end());
  return shared;
}

std::vector<Eigen::Vector3f> color_gains(std::span<const SharedColor> shared,
                                         std::size_t view_count) {
  std::vector<Eigen::Vector3f> gains(view_count, Eigen::Vector3f::Ones());
  for (int channel = 0; channel < 3; ++channel) {
    const auto of_channel = ratios(shared, channel);
    if (of_channel.empty()) continue;
    const Eigen::VectorXd logs = log_gains(of_channel, view_count);
    for (std::size_t i = 0; i < view_count; ++i) {
      const double gain = std::exp(logs[static_cast<Eigen::Index>(i)]);
      gains[i][channel] = std::clamp(static_cast<float>(gain), kMinGain, kMaxGain);
    }
  }
  return gains;
}

}  // namespace roomcast::model
