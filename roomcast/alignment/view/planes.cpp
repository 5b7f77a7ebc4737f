// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/planes.h"

#include <cmath>
#include <random>

#include "roomcast/geometry/dense_solvers.h"

namespace roomcast::alignment {
namespace {

struct Flat {
  Eigen::Vector3f normal;
  float offset_m;
};

bool lies_on(const Flat& plane, const SurfacePoint& sample, const PlaneOptions& options) {
  return std::abs(plane.normal.dot(sample.point_m) + plane.offset_m) < options.thickness_m &&
         sample.normal.dot(plane.normal) > options.min_cosine;
}

/// The plane with most inliers among planes through single samples.
Flat best_trial(std::span<const SurfacePoint> samples, const PlaneOptions& options,
                std::mt19937& random) {
  const std::size_t step = std::max<std::size_t>(1, samples.size() / options.tested_samples);
  Flat best{Eigen::Vector3f::UnitZ(), 0};
  std::size_t most = 0;
  for (int trial = 0; trial < options.trials; ++trial) {
    const SurfacePoint& seed = samples[random() % samples.size()];
    const Flat plane{seed.normal, -seed.normal.dot(seed.point_m)};
    std::size_t count = 0;
    for (std::size_t i = 0; i < samples.size(); i += step)
      count += lies_on(plane, samples[i], options);
    if (count > most) most = count, best = plane;
  }
  return best;
}

/// Least-squares fit to the samples on `plane`; `plane` itself if they are too few.
Flat fitted(const Flat& plane, std::span<const SurfacePoint> samples, const PlaneOptions& options) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  double count = 0;
  for (const SurfacePoint& sample : samples) {
    if (!lies_on(plane, sample, options)) continue;
    const Eigen::Vector3d point = sample.point_m.cast<double>();
    mean += point;
    moments += point * point.transpose();
    ++count;
  }
  if (count < double(options.min_points)) return plane;
  mean /= count;
  Eigen::Vector3d normal = thinnest_direction(moments / count - mean * mean.transpose());
  if (normal.dot(plane.normal.cast<double>()) < 0) normal = -normal;
  return {normal.cast<float>(), static_cast<float>(-normal.dot(mean))};
}

}  // namespace

std::vector<Plane> find_planes(std::span<const SurfacePoint> samples, const PlaneOptions& options) {
  std::mt19937 random(1);  // fixed seed: the same samples give the same planes
  std::vector<SurfacePoint> rest(samples.begin(), samples.end());
  const auto least = static_cast<std::size_t>(options.min_share * float(samples.size()));
  std::vector<Plane> planes;
  for (std::size_t attempt = 0;
       attempt < 2 * options.max_planes && planes.size() < options.max_planes; ++attempt) {
    if (rest.size() < std::max(least, options.min_points)) break;
    Flat flat = best_trial(rest, options, random);
    for (int i = 0; i < options.refinements; ++i) flat = fitted(flat, rest, options);
    Plane plane{flat.normal, flat.offset_m, {}};
    std::vector<SurfacePoint> left;
    for (const SurfacePoint& sample : rest) {
      if (lies_on(flat, sample, options)) {
        plane.points_m.push_back(sample.point_m);
      } else {
        left.push_back(sample);
      }
    }
    if (plane.points_m.size() < options.min_points) break;
    if (plane.points_m.size() > least) planes.push_back(std::move(plane));
    rest = std::move(left);
  }
  return planes;
}

}  // namespace roomcast::alignment
