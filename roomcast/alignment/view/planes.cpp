// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/planes.h"

#include <cmath>
#include <random>

#include <Eigen/Eigenvalues>

#include "roomcast/alignment/view/depth_noise.h"

namespace roomcast::alignment {
namespace {

constexpr int kTrials = 60;
constexpr std::size_t kTested = 2000;  // about so many samples score a trial
constexpr float kPlaneThickness_m = 0.025F;
constexpr float kPlaneCosine = 0.85F;  // cosine between normals
constexpr int kRefinements = 3;
constexpr std::size_t kMinPoints = 50;

struct Flat {
  Eigen::Vector3f normal;
  float offset_m;
};

bool lies_on(const Flat& plane, const SurfacePoint& sample) {
  return std::abs(plane.normal.dot(sample.point_m) + plane.offset_m) < kPlaneThickness_m &&
         sample.normal.dot(plane.normal) > kPlaneCosine;
}

/// The plane with most inliers among kTrials planes through single samples.
Flat best_trial(std::span<const SurfacePoint> samples, std::mt19937& random) {
  const std::size_t step = std::max<std::size_t>(1, samples.size() / kTested);
  Flat best{Eigen::Vector3f::UnitZ(), 0};
  std::size_t most = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const SurfacePoint& seed = samples[random() % samples.size()];
    const Flat plane{seed.normal, -seed.normal.dot(seed.point_m)};
    std::size_t count = 0;
    for (std::size_t i = 0; i < samples.size(); i += step) count += lies_on(plane, samples[i]);
    if (count > most) most = count, best = plane;
  }
  return best;
}

/// Least-squares fit to the samples on `plane`; `plane` itself if they are too few.
Flat fitted(const Flat& plane, std::span<const SurfacePoint> samples) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  double count = 0;
  for (const SurfacePoint& sample : samples) {
    if (!lies_on(plane, sample)) continue;
    const Eigen::Vector3d point = sample.point_m.cast<double>();
    mean += point;
    moments += point * point.transpose();
    ++count;
  }
  if (count < double(kMinPoints)) return plane;
  mean /= count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments / count -
                                                            mean * mean.transpose());
  Eigen::Vector3d normal = axes.eigenvectors().col(0);
  if (normal.dot(plane.normal.cast<double>()) < 0) normal = -normal;
  return {normal.cast<float>(), static_cast<float>(-normal.dot(mean))};
}

}  // namespace

std::vector<Plane> find_planes(std::span<const SurfacePoint> samples) {
  std::mt19937 random(1);  // fixed seed: the same samples give the same planes
  std::vector<SurfacePoint> rest(samples.begin(), samples.end());
  const auto least = static_cast<std::size_t>(kSmallestPlaneShare * float(samples.size()));
  std::vector<Plane> planes;
  for (std::size_t attempt = 0; attempt < 2 * kMaxPlanes && planes.size() < kMaxPlanes; ++attempt) {
    if (rest.size() < std::max(least, kMinPoints)) break;
    Flat flat = best_trial(rest, random);
    for (int i = 0; i < kRefinements; ++i) flat = fitted(flat, rest);
    Plane plane{flat.normal, flat.offset_m, {}};
    std::vector<SurfacePoint> left;
    for (const SurfacePoint& sample : rest) {
      if (lies_on(flat, sample)) {
        plane.points_m.push_back(sample.point_m);
      } else {
        left.push_back(sample);
      }
    }
    if (plane.points_m.size() < kMinPoints) break;
    if (plane.points_m.size() > least) planes.push_back(std::move(plane));
    rest = std::move(left);
  }
  return planes;
}

}  // namespace roomcast::alignment
