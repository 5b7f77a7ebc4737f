// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/free_space.h"

#include <algorithm>
#include <cmath>

namespace roomcast::alignment {
namespace {

struct Counts {
  std::size_t consistent = 0, violating = 0, occluded = 0, tested = 0;
};

enum class Verdict { kNothing, kConsistent, kViolating, kOccluded };

Verdict judge(const DepthSurface& target, const Eigen::Vector3f& point,
              const Eigen::Vector3f& normal, const FreeSpaceOptions& options) {
  Eigen::Vector2f pixel;
  if (!target.lens.project(point, pixel)) return Verdict::kNothing;
  const int u = static_cast<int>(std::lround(pixel.x())),
            v = static_cast<int>(std::lround(pixel.y()));
  const int border = options.border_px;
  if (u < border || v < border || u >= target.z_m.width() - border ||
      v >= target.z_m.height() - border) {
    return Verdict::kNothing;
  }
  const float z = point.z(), seen = target.z_m.at(u, v);
  const float nearest = target.range.nearest_m.at(u, v),
              farthest = target.range.farthest_m.at(u, v);
  const float sigma = target.options.noise.sigma_m(z);
  if (farthest > 0 && z > farthest + options.behind_sigmas * sigma) return Verdict::kOccluded;
  if (!(seen > 0)) return Verdict::kNothing;
  if (z < nearest - options.in_front_sigmas * sigma) return Verdict::kViolating;
  const float facing = -normal.dot(point.normalized());
  if (facing < options.from_behind_cosine && std::abs(z - seen) < options.same_surface_m)
    return Verdict::kViolating;
  if (facing > 0 && std::abs(z - seen) < options.same_reading_sigmas * sigma)
    return Verdict::kConsistent;
  return Verdict::kNothing;
}

Counts count(const DepthSurface& source, const DepthSurface& target,
             const RigidTransform& target_from_source, std::size_t points,
             const FreeSpaceOptions& options) {
  const Eigen::Matrix3f rotation = target_from_source.rotation.cast<float>();
  const Eigen::Vector3f shift = target_from_source.translation_m.cast<float>();
  const std::size_t step = std::max<std::size_t>(1, source.samples.size() / points);
  Counts counts;
  for (std::size_t i = 0; i < source.samples.size(); i += step) {
    const SurfacePoint& sample = source.samples[i];
    const Verdict verdict =
        judge(target, rotation * sample.point_m + shift, rotation * sample.normal, options);
    counts.consistent += verdict == Verdict::kConsistent;
    counts.violating += verdict == Verdict::kViolating;
    counts.occluded += verdict == Verdict::kOccluded;
    ++counts.tested;
  }
  return counts;
}

/// Judges a block of the source's picture: violating or consistent if enough of its points are.
Verdict judge_block(const DepthSurface& source, const DepthSurface& target,
                    const Eigen::Matrix3f& rotation, const Eigen::Vector3f& shift, int left,
                    int top, int step, const FreeSpaceOptions& options) {
  int violating = 0, consistent = 0;
  for (int y = top; y < top + kBlockPoints * step; y += step) {
    for (int x = left; x < left + kBlockPoints * step; x += step) {
      const SurfacePoint& here = source.at.at(x, y);
      if (!(here.normal.squaredNorm() > 0)) continue;
      const Verdict verdict =
          judge(target, rotation * here.point_m + shift, rotation * here.normal, options);
      violating += verdict == Verdict::kViolating;
      consistent += verdict == Verdict::kConsistent;
    }
  }
  if (violating >= options.min_of_block) return Verdict::kViolating;
  return consistent >= options.min_of_block ? Verdict::kConsistent : Verdict::kNothing;
}

void add_blocks(const DepthSurface& source, const DepthSurface& target,
                const RigidTransform& target_from_source, const FreeSpaceOptions& options,
                SolidConflict& conflict) {
  const Eigen::Matrix3f rotation = target_from_source.rotation.cast<float>();
  const Eigen::Vector3f shift = target_from_source.translation_m.cast<float>();
  const int step = std::max(1, source.at.width() / options.points_across),
            block = kBlockPoints * step;
  for (int top = 0; top + block <= source.at.height(); top += block) {
    for (int left = 0; left + block <= source.at.width(); left += block) {
      const Verdict verdict =
          judge_block(source, target, rotation, shift, left, top, step, options);
      conflict.consistent += verdict == Verdict::kConsistent;
      conflict.violating += verdict == Verdict::kViolating;
    }
  }
}

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

FreeSpaceCheck check_free_space(const DepthSurface& a, const DepthSurface& b,
                                const RigidTransform& a_from_b, std::size_t points,
                                const FreeSpaceOptions& options) {
  const Counts of_b = count(b, a, a_from_b, points, options);
  const Counts of_a = count(a, b, a_from_b.inverse(), points, options);
  const std::size_t tested = of_a.tested + of_b.tested;
  return {share(of_a.consistent + of_b.consistent, tested),
          share(of_a.violating + of_b.violating, tested),
          share(of_a.occluded + of_b.occluded, tested),
          std::min(share(of_a.consistent, of_a.tested), share(of_b.consistent, of_b.tested))};
}

SolidConflict check_solid_conflict(const DepthSurface& a, const DepthSurface& b,
                                   const RigidTransform& a_from_b,
                                   const FreeSpaceOptions& options) {
  SolidConflict conflict;
  add_blocks(b, a, a_from_b, options, conflict);
  add_blocks(a, b, a_from_b.inverse(), options, conflict);
  return conflict;
}

}  // namespace roomcast::alignment
