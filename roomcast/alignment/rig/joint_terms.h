// SPDX-License-Identifier: Apache-2.0
// What the sensors of a rig say about their poses, depth scales and lenses, as scalar residuals
// along directions: surfaces that stand still, features, surfaces that move and round things that
// move, seen at the same instant by both. Metres. Single-threaded.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "roomcast/alignment/pair/moving_partners.h"
#include "roomcast/alignment/pair/round_things.h"
#include "roomcast/alignment/rig/pose_selection.h"

namespace roomcast::alignment {

struct ScaledPose {
  RigidTransform origin_from_sensor;
  double scale = 1;  // factor on the readings

  /// Where a measured point is, in the origin's frame.
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& measured_m) const {
    return origin_from_sensor * (scale * measured_m);
  }
};

enum class Evidence { kStill, kFeatures, kMoving, kRound };
inline constexpr Evidence kEvidence[] = {Evidence::kStill, Evidence::kFeatures, Evidence::kMoving,
                                         Evidence::kRound};

/// Two sensors saw one place: residual = direction . (place by b - place by a).
struct JointTerm {
  Eigen::Vector3d a_m, b_m;   // as measured, in the depth frames
  Eigen::Vector3d direction;  // unit, in the origin's frame
  double residual_m = 0, sigma_m = 1;
};

/// Reaches shrink from step to step of a fit.
struct JointReach {
  double still_m = 0.15, moving_m = 0.25;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("still_m", still_m, Range{0.001, 10});
    visit("moving_m", moving_m, Range{0.001, 10});
  }
  [[nodiscard]] Status check() const { return check_fields("JointReach", *this); }
};

struct JointTermOptions {
  std::size_t points = 4000;  // of still surface, of each view of a pair
  double feature_sigma_m = 0.03, round_sigma_m = 0.02;
  double max_radius_difference = 0.3;  // of one round thing, seen by two sensors
  MovingSurfaceOptions moving_surface;
  MovingPartnerOptions moving;
  RoundThingOptions round;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("points", points, Range{1, 1e6});
    visit("feature_sigma_m", feature_sigma_m, Range{1e-4, 1});
    visit("round_sigma_m", round_sigma_m, Range{1e-4, 1});
    visit("max_radius_difference", max_radius_difference, Range{0, 10});
    visit("moving_surface", moving_surface);
    visit("moving", moving);
    visit("round", round);
  }
  [[nodiscard]] Status check() const { return check_fields("JointTermOptions", *this); }
};

class JointTerms {
 public:
  /// The pairs' candidates must outlive this object.
  JointTerms(std::size_t sensors, std::span<const RigPair> pairs,
             const JointTermOptions& options = {}, const SurfaceResidualOptions& still = {});

  [[nodiscard]] std::span<const RigPair> pairs() const { return pairs_; }
  [[nodiscard]] std::vector<JointTerm> of(const RigPair& pair, Evidence kind,
                                          std::span<const ScaledPose> poses,
                                          const JointReach& reach) const;
  /// Instants in which both sensors of the pair saw the same thing moving.
  [[nodiscard]] std::size_t common_instants(const RigPair& pair, std::span<const ScaledPose> poses,
                                            const JointReach& reach) const;
  [[nodiscard]] const SensorView* view(std::size_t sensor) const { return views_[sensor]; }

 private:
  [[nodiscard]] MovingPartners moving(const RigPair& pair, std::span<const ScaledPose> poses,
                                      const JointReach& reach) const;
  [[nodiscard]] std::vector<JointTerm> still_terms(const RigPair& pair,
                                                   std::span<const ScaledPose> poses,
                                                   const JointReach& reach) const;
  [[nodiscard]] std::vector<JointTerm> feature_terms(const RigPair& pair,
                                                     std::span<const ScaledPose> poses,
                                                     const JointReach& reach) const;
  [[nodiscard]] std::vector<JointTerm> moving_terms(const RigPair& pair,
                                                    std::span<const ScaledPose> poses,
                                                    const JointReach& reach) const;
  [[nodiscard]] std::vector<JointTerm> round_terms(const RigPair& pair,
                                                   std::span<const ScaledPose> poses,
                                                   const JointReach& reach) const;

  std::span<const RigPair> pairs_;
  JointTermOptions options_;
  SurfaceResidualOptions still_;
  std::vector<const SensorView*> views_;              // by sensor; null if in no pair
  std::vector<std::vector<MovingSurface>> surfaces_;  // by sensor
  std::vector<std::vector<RoundThing>> round_;        // by sensor
};

}  // namespace roomcast::alignment
