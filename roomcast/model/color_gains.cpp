// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/color_gains.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "roomcast/geometry/color_balance.h"

namespace roomcast::model {
namespace {

constexpr std::size_t kMaxPoints = 60'000;
constexpr float kMinQualityShare = 0.2F;          // of the better of two views
constexpr float kDarkest = 16, kBrightest = 240;  // levels beyond are clipped, or noise
constexpr std::size_t kMinShared = 200;           // of a pair of views
constexpr double kPrior = 1e-3;                   // of a gain of 1, beside all that is shared

bool is_exposed(const Eigen::Vector3f& color) {
  return color.minCoeff() >= kDarkest && color.maxCoeff() <= kBrightest;
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

/// The median of each pair of views that share enough.
std::vector<ColorRatio> ratios_of_pairs(std::span<const SharedColor> shared) {
  std::map<std::pair<std::size_t, std::size_t>, ChannelLogs> of_pair;
  for (const SharedColor& place : shared) {
    if (!is_exposed(place.color_a) || !is_exposed(place.color_b)) continue;
    auto& logs = of_pair[{place.view_a, place.view_b}];
    for (int c = 0; c < 3; ++c)
      logs[static_cast<std::size_t>(c)].push_back(
          std::log(static_cast<double>(place.color_b[c] / place.color_a[c])));
  }
  std::vector<ColorRatio> ratios;
  for (auto& [pair, logs] : of_pair) {
    if (logs[0].size() >= kMinShared) ratios.push_back(median_ratio(pair.first, pair.second, logs));
  }
  return ratios;
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
  const auto ratios = ratios_of_pairs(shared);
  double places = 1;
  for (const ColorRatio& ratio : ratios) places += ratio.places;
  const Eigen::MatrixXd logs = log_gains(ratios, view_count, kPrior * places);
  std::vector<Eigen::Vector3f> gains;
  for (Eigen::Index i = 0; i < logs.rows(); ++i) {
    const Eigen::Vector3f gain = logs.row(i).transpose().array().exp().matrix().cast<float>();
    gains.push_back(gain.cwiseMax(kMinGain).cwiseMin(kMaxGain));
  }
  return gains;
}

}  // namespace roomcast::model
