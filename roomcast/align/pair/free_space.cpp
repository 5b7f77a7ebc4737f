// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/pair/free_space.h"

#include <algorithm>
#include <cmath>

#include "roomcast/align/view/depth_noise.h"

namespace roomcast::align {
namespace {

// In sigmas of the depth noise. Wide, because hypotheses are tested before they are refined.
constexpr float kSurelyInFront = 8, kSurelyBehind = 5, kSameReading = 10;
constexpr float kSameSurface_m = 0.02F;  // seen from both sides only if it is paper
constexpr float kFromBehind = -0.3F;     // cosine
constexpr int kBorder = 4;               // pixels

struct Counts {
  std::size_t consistent = 0, violating = 0, occluded = 0, tested = 0;
};

enum class Verdict { kNothing, kConsistent, kViolating, kOccluded };

Verdict judge(const DepthSurface& target, const Eigen::Vector3f& point,
              const Eigen::Vector3f& normal) {
  Eigen::Vector2f pixel;
  if (!target.lens.project(point, pixel)) return Verdict::kNothing;
  const int u = static_cast<int>(std::lround(pixel.x())),
            v = static_cast<int>(std::lround(pixel.y()));
  if (u < kBorder || v < kBorder || u >= target.z_m.width() - kBorder ||
      v >= target.z_m.height() - kBorder) {
    return Verdict::kNothing;
  }
  const float z = point.z(), seen = target.z_m.at(u, v);
  const float nearest = target.range.nearest_m.at(u, v),
              farthest = target.range.farthest_m.at(u, v);
  const float sigma = depth_sigma_m(z);
  if (farthest > 0 && z > farthest + kSurelyBehind * sigma) return Verdict::kOccluded;
  if (!(seen > 0)) return Verdict::kNothing;
  if (z < nearest - kSurelyInFront * sigma) return Verdict::kViolating;
  const float facing = -normal.dot(point.normalized());
  if (facing < kFromBehind && std::abs(z - seen) < kSameSurface_m) return Verdict::kViolating;
  if (facing > 0 && std::abs(z - seen) < kSameReading * sigma) return Verdict::kConsistent;
  return Verdict::kNothing;
}

Counts count(const DepthSurface& source, const DepthSurface& target,
             const RigidTransform& target_from_source, std::size_t points) {
  const Eigen::Matrix3f rotation = target_from_source.rotation.cast<float>();
  const Eigen::Vector3f shift = target_from_source.translation_m.cast<float>();
  const std::size_t step = std::max<std::size_t>(1, source.samples.size() / points);
  Counts counts;
  for (std::size_t i = 0; i < source.samples.size(); i += step) {
    const SurfacePoint& sample = source.samples[i];
    const Verdict verdict =
        judge(target, rotation * sample.point_m + shift, rotation * sample.normal);
    counts.consistent += verdict == Verdict::kConsistent;
    counts.violating += verdict == Verdict::kViolating;
    counts.occluded += verdict == Verdict::kOccluded;
    ++counts.tested;
  }
  return counts;
}

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

FreeSpaceCheck check_free_space(const DepthSurface& a, const DepthSurface& b,
                                const RigidTransform& a_from_b, std::size_t points) {
  const Counts of_b = count(b, a, a_from_b, points);
  const Counts of_a = count(a, b, a_from_b.inverse(), points);
  const std::size_t tested = of_a.tested + of_b.tested;
  return {share(of_a.consistent + of_b.consistent, tested),
          share(of_a.violating + of_b.violating, tested),
          share(of_a.occluded + of_b.occluded, tested),
          std::min(share(of_a.consistent, of_a.tested), share(of_b.consistent, of_b.tested))};
}

}  // namespace roomcast::align
