// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/rig_refinement.h"

#include <algorithm>
#include <cmath>

#include "roomcast/alignment/pair/corrected_matches.h"
#include "roomcast/alignment/rig/rig_equations.h"

namespace roomcast::alignment {
namespace {

struct RefinementRules {
  RigRefinementOptions refinement;
  ResidualOptions residuals;
};

/// A pair and the matches that agreed with it when refinement began.
struct ActivePair {
  const RigPair* pair;
  std::vector<PointMatch> agreeing;
};

PairState state_of(const RigPair& pair, std::span<const RefinedSensor> sensors) {
  const RefinedSensor& a = sensors[pair.first];
  const RefinedSensor& b = sensors[pair.second];
  return {a.origin_from_sensor.inverse() * b.origin_from_sensor, a.correction, b.correction};
}

/// Initial colour corrections: the mean of the pairs' own estimates, weighted by match support.
void initialise_corrections(std::span<const RigPair> pairs, std::vector<RefinedSensor>& sensors) {
  std::vector<double> weights(sensors.size());
  for (const RigPair& pair : pairs) {
    const PoseEvidence* said = pair.candidates->nearest(state_of(pair, sensors).a_from_b);
    if (!said) continue;
    for (const auto& [sensor, correction] :
         {std::pair(pair.first, said->correction_a), std::pair(pair.second, said->correction_b)}) {
      sensors[sensor].correction.color_shift_px += said->matches.weight * correction.color_shift_px;
      weights[sensor] += said->matches.weight;
    }
  }
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (weights[i] > 0) sensors[i].correction.color_shift_px /= weights[i];
  }
}

std::vector<PointMatch> agreeing_at(const RigPair& pair, std::span<const RefinedSensor> sensors,
                                    float reach_m) {
  const PairState state = state_of(pair, sensors);
  const PairCandidates& candidates = *pair.candidates;
  return agreeing_matches(corrected_matches(candidates.matches(), candidates.a().picture,
                                            candidates.b().picture, state),
                          state.a_from_b, reach_m);
}

/// Surfaces and features that a pair's sensors share at the current poses.
struct Shared {
  PairState state;
  std::vector<SurfacePartner> partners;
  double noise;
  FeatureTrust trust;

  Shared(const ActivePair& held, std::span<const RefinedSensor> sensors,
         const RefinementRules& rules, float reach_m)
      : state(state_of(*held.pair, sensors)) {
    const SensorView& a = held.pair->candidates->a();
    const SensorView& b = held.pair->candidates->b();
    partners = surface_partners(a.surface, b.surface, state.a_from_b,
                                {reach_m, rules.refinement.points}, rules.residuals.surfaces);
    noise = surface_noise(partners, rules.residuals.surfaces);
    const double independent = rules.refinement.independent_features;
    const double features = std::max(independent, static_cast<double>(held.agreeing.size()));
    trust = {feature_sigma_px(a.picture, b.picture, state, held.agreeing, rules.residuals.features),
             independent / features};
  }
};

PairEquations equations_of(const ActivePair& held, const Shared& shared,
                           const ResidualOptions& options) {
  const PairCandidates& pair = *held.pair->candidates;
  PairEquations equations =
      surface_equations(shared.partners, shared.state.a_from_b, shared.noise, options.surfaces);
  equations.add(feature_equations(pair.a().picture, pair.b().picture, shared.state, held.agreeing,
                                  shared.trust, options.features));
  return equations;
}

PairScores scores_of(const ActivePair& held, const Shared& shared, const RefinementRules& rules) {
  const PairCandidates& pair = *held.pair->candidates;
  PairScores scores;
  scores.patches = rules.refinement.patches;
  add_surface_scores(shared.partners, shared.state.a_from_b, shared.noise, scores,
                     rules.residuals.surfaces);
  add_feature_scores(pair.a().picture, pair.b().picture, shared.state, held.agreeing, shared.trust,
                     scores, rules.residuals.features);
  return scores;
}

RigEquations rig_equations(std::span<const ActivePair> pairs,
                           std::span<const RefinedSensor> sensors, std::size_t origin,
                           const RefinementRules& rules, float reach_m) {
  RigEquations rig(sensors.size(), origin);
  for (const ActivePair& held : pairs) {
    const RigPair& pair = *held.pair;
    rig.add(pair.first, pair.second, sensors[pair.first].origin_from_sensor,
            equations_of(held, Shared(held, sensors, rules, reach_m), rules.residuals));
  }
  for (std::size_t i = 0; i < sensors.size(); ++i)
    rig.add_prior(i, sensors[i].correction, rules.residuals.color_shift);
  return rig;
}

RigScatter rig_scatter(std::span<const ActivePair> pairs, std::span<const RefinedSensor> sensors,
                       const RefinementRules& rules, float reach_m) {
  RigScatter scatter(sensors.size());
  for (const ActivePair& held : pairs) {
    const RigPair& pair = *held.pair;
    scatter.add(pair.first, pair.second, sensors[pair.first].origin_from_sensor,
                scores_of(held, Shared(held, sensors, rules, reach_m), rules));
  }
  return scatter;
}

/// Applies one step; returns the largest component of any motion.
double move(std::vector<RefinedSensor>& sensors, const RigEquations& equations) {
  const auto steps = equations.solve();
  double largest = 0;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const Vector6 motion = steps[i].head<6>();
    sensors[i].origin_from_sensor = step_transform(motion) * sensors[i].origin_from_sensor;
    sensors[i].correction.color_shift_px += steps[i].segment<2>(6 + kShift);
    largest = std::max(largest, motion.cwiseAbs().maxCoeff());
  }
  return largest;
}

/// Gauss-Newton until convergence, or until the steps are used up.
void settle(std::span<const ActivePair> held, std::size_t origin, const RefinementRules& rules,
            std::vector<RefinedSensor>& sensors) {
  const RigRefinementOptions& options = rules.refinement;
  float reach_m = options.reach_m;
  for (int i = 0; i < options.max_steps; ++i) {
    const double largest = move(sensors, rig_equations(held, sensors, origin, rules, reach_m));
    if (reach_m == options.min_reach_m && largest < options.still) break;
    reach_m = std::max(options.min_reach_m, options.shrink * reach_m);
  }
}

/// Constraints between sensors: matching places and surfaces that both see.
struct Hold {
  double matches = 0, common = 0;

  Hold(std::span<const ActivePair> held, std::span<const RefinedSensor> sensors, float reach_m) {
    for (const ActivePair& each : held) {
      const PairCandidates& pair = *each.pair->candidates;
      const PairState state = state_of(*each.pair, sensors);
      const PairOptions& options = pair.options();
      const FreeSpaceOptions& space = options.free_space;
      matches += match_support(agreeing_at(*each.pair, sensors, reach_m), options.support).weight;
      common +=
          check_free_space(pair.a().surface, pair.b().surface, state.a_from_b, space.points, space)
              .consistent;
    }
  }
  [[nodiscard]] bool is_lost_from(const Hold& start, const RigRefinementOptions& options) const {
    return common < options.min_common_kept * start.common ||
           matches < options.min_matches_kept * start.matches;
  }
};

/// Total score of all pairs' poses.
double evidence_for(std::span<const ActivePair> held, std::span<const RefinedSensor> sensors) {
  double score = 0;
  for (const ActivePair& each : held)
    score += each.pair->candidates->examine(state_of(*each.pair, sensors)).score;
  return score;
}

/// Whether refinement slid surfaces along each other until they share less, which happens where
/// views share little. A lower score alone is no proof: colours misaligned with depth favour the
/// worse pose.
bool slid(std::span<const ActivePair> held, std::span<const RefinedSensor> start,
          std::span<const RefinedSensor> refined, const RigRefinementOptions& options) {
  const float reach_m = options.feature_reach_m;
  return Hold(held, refined, reach_m).is_lost_from(Hold(held, start, reach_m), options) &&
         evidence_for(held, refined) < options.min_evidence_kept * evidence_for(held, start);
}

void add_covariance(std::span<const ActivePair> held, std::size_t origin,
                    const RefinementRules& rules, std::vector<RefinedSensor>& sensors) {
  const float reach_m = rules.refinement.min_reach_m;
  const RigScatter scatter = rig_scatter(held, sensors, rules, reach_m);
  const DepthUncertainty& doubt = rules.refinement.depth_uncertainty;
  const double disagreement_m = scatter.disagreement_m();
  const RigEquations equations = rig_equations(held, sensors, origin, rules, reach_m);
  const auto said = equations.motion_covariance(scatter, doubt.given(disagreement_m));
  const auto weighed = equations.motion_covariance(scatter, doubt.weighed_given(disagreement_m));
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    sensors[i].covariance = said[i];
    sensors[i].weighed_covariance = weighed[i];
    sensors[i].uncalibrated_belief = doubt.uncalibrated_belief(disagreement_m);
  }
}

}  // namespace

std::vector<RefinedSensor> refine_rig(std::span<const RigidTransform> origin_from_sensor,
                                      std::size_t origin, std::span<const RigPair> pairs,
                                      const RigRefinementOptions& options,
                                      const ResidualOptions& residuals) {
  const RefinementRules rules{options, residuals};
  std::vector<RefinedSensor> start;
  for (const RigidTransform& pose : origin_from_sensor) start.push_back({pose, {}});
  initialise_corrections(pairs, start);
  std::vector<ActivePair> held;
  for (const RigPair& pair : pairs)
    held.push_back({&pair, agreeing_at(pair, start, options.feature_reach_m)});
  std::vector<RefinedSensor> refined = start;
  settle(held, origin, rules, refined);
  if (slid(held, start, refined, options)) refined = start;
  add_covariance(held, origin, rules, refined);
  return refined;
}

}  // namespace roomcast::alignment
