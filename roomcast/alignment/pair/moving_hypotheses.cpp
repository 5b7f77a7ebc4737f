// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/moving_hypotheses.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/geometry/rotations.h"

namespace roomcast::alignment {
namespace {

/// Where the middle of all that moves is at one instant in two level frames (y up, floor at 0).
struct SeenByBoth {
  Eigen::Vector3d in_a, in_b;
};

RigidTransform upright_from(const Plane& floor) {
  RigidTransform upright;
  upright.rotation = rotation_between(floor.normal.cast<double>(), Eigen::Vector3d::UnitY());
  upright.translation_m.y() = double(floor.offset_m);
  return upright;
}

/// Middle of the moving points, pushed away from the sensor by half a person; nothing if too few
/// move.
std::optional<Eigen::Vector3d> middle_of_moving(const SensorView& view, const DepthInstant& instant,
                                                const RigidTransform& upright_from_view,
                                                double inside_m, std::size_t min_blocks) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t count = 0;
  for (int y = 0; y < instant.moving.height(); ++y) {
    for (int x = 0; x < instant.moving.width(); ++x) {
      if (instant.moving.at(x, y) == 0 || view.block_rays.at(x, y).hasNaN()) continue;
      const double z_m = 0.001 * instant.depth_mm.at(x, y);
      sum += z_m * view.block_rays.at(x, y).cast<double>().homogeneous();
      ++count;
    }
  }
  if (count < min_blocks) return std::nullopt;
  const Eigen::Vector3d middle = sum / static_cast<double>(count);
  const Eigen::Vector3d away = (upright_from_view.rotation * middle).normalized();
  return upright_from_view * middle + inside_m * away;
}

std::vector<SeenByBoth> moments_of(const SensorView& a, const SensorView& b,
                                   const RigidTransform& upright_from_a,
                                   const RigidTransform& upright_from_b,
                                   const MovingHypothesisOptions& options,
                                   const MovingConsistencyOptions& moving) {
  std::vector<SeenByBoth> moments;
  for (const DepthInstant& of_b : b.instants) {
    const DepthInstant* const of_a = instant_at(a.instants, of_b.time_s, moving.max_apart_s);
    if (!of_a) continue;
    const auto in_a =
        middle_of_moving(a, *of_a, upright_from_a, options.inside_m, moving.min_blocks);
    const auto in_b =
        middle_of_moving(b, of_b, upright_from_b, options.inside_m, moving.min_blocks);
    if (in_a && in_b) moments.push_back({*in_a, *in_b});
  }
  return moments;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The horizontal shift between the level frames at this turn, if all moments agree on it.
std::optional<Eigen::Vector3d> shift_at(const Eigen::Matrix3d& turn,
                                        const std::vector<SeenByBoth>& moments,
                                        double max_scatter_m) {
  std::vector<double> x, z, scatter;
  for (const SeenByBoth& moment : moments) {
    const Eigen::Vector3d shift = moment.in_a - turn * moment.in_b;
    x.push_back(shift.x());
    z.push_back(shift.z());
  }
  const Eigen::Vector3d middle(median_of(x), 0, median_of(z));
  for (std::size_t i = 0; i < x.size(); ++i)
    scatter.push_back(std::hypot(x[i] - middle.x(), z[i] - middle.z()));
  if (median_of(scatter) > max_scatter_m) return std::nullopt;
  return middle;
}

/// A turn's pose after coarse refinement, rated by the surface that both see.
std::optional<PoseHypothesis> rated(const SensorView& a, const SensorView& b,
                                    const RigidTransform& a_from_b,
                                    const MovingHypothesisOptions& options,
                                    const MovingConsistencyOptions& moving,
                                    const FreeSpaceOptions& space) {
  const MovingConsistency moved = check_moving(a, b, a_from_b, moving);
  const FreeSpaceCheck check =
      check_free_space(a.surface, b.surface, a_from_b, options.coarse.points, space);
  if (check.conflict() > options.max_conflict) return std::nullopt;
  return PoseHypothesis{a_from_b,
                        check.consistent - check.violating + 0.1 * (1 - 2 * moved.conflict())};
}

}  // namespace

std::vector<PoseHypothesis> hypotheses_by_motion(const SensorView& a, const SensorView& b,
                                                 const MovingHypothesisOptions& options,
                                                 const MovingConsistencyOptions& moving,
                                                 const FreeSpaceOptions& space) {
  std::vector<PoseHypothesis> found;
  if (!a.floor || !b.floor) return found;
  const RigidTransform upright_from_a = upright_from(*a.floor);
  const RigidTransform upright_from_b = upright_from(*b.floor);
  const auto moments = moments_of(a, b, upright_from_a, upright_from_b, options, moving);
  if (moments.size() < options.min_instants) return found;
  for (int i = 0; i < options.turns; ++i) {
    RigidTransform turn;
    turn.rotation =
        rotation_about(Eigen::Vector3d::UnitY(), 2 * std::numbers::pi * i / options.turns);
    const auto shift = shift_at(turn.rotation, moments, options.max_scatter_m);
    if (!shift) continue;
    turn.translation_m = *shift;
    const RigidTransform start = upright_from_a.inverse() * turn * upright_from_b;
    const RigidTransform moved =
        refined_pose(a, b, {}, start, ColorCalibration::kAsCalibrated, options.coarse).a_from_b;
    if (const auto hypothesis = rated(a, b, moved, options, moving, space))
      found.push_back(*hypothesis);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& one, const auto& other) { return one.support > other.support; });
  std::vector<PoseHypothesis> kept;
  for (const PoseHypothesis& each : found) {
    const bool is_new = std::ranges::all_of(kept, [&](const PoseHypothesis& better) {
      return are_rivals(each.a_from_b, better.a_from_b);
    });
    if (is_new && kept.size() < options.kept) kept.push_back(each);
  }
  return kept;
}

}  // namespace roomcast::alignment
