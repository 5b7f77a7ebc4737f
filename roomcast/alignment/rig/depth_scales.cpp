// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/depth_scales.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "roomcast/alignment/pair/corrected_matches.h"
#include "roomcast/alignment/rig/rig_equations.h"

namespace roomcast::alignment {
namespace {

/// Poses and scales as they are now.
struct ScaledRig {
  std::vector<RefinedSensor> sensors;
  std::vector<double> scales;
  std::vector<double> moving;  // per sensor: independent partners that move
};

void scale(SurfacePoint& point, float factor) {
  point.point_m *= factor;
}

/// The surface as it would be with all readings multiplied.
DepthSurface scaled(const DepthSurface& surface, double scale_of_depth) {
  const auto factor = static_cast<float>(scale_of_depth);
  DepthSurface out = surface;
  for (SurfacePoint& sample : out.samples) scale(sample, factor);
  for (int y = 0; y < out.at.height(); ++y) {
    for (int x = 0; x < out.at.width(); ++x) scale(out.at.at(x, y), factor);
  }
  return out;
}

std::map<std::size_t, DepthSurface> scaled_surfaces(std::span<const RigPair> pairs,
                                                    const ScaledRig& rig) {
  std::map<std::size_t, DepthSurface> surfaces;
  const auto add = [&](std::size_t i, const SensorView& view) {
    if (!surfaces.contains(i)) surfaces.emplace(i, scaled(view.surface, rig.scales[i]));
  };
  for (const RigPair& pair : pairs) {
    add(pair.first, pair.candidates->a());
    add(pair.second, pair.candidates->b());
  }
  return surfaces;
}

std::vector<PointMatch> scaled_matches(const RigPair& pair, const ScaledRig& rig) {
  std::vector<PointMatch> matches = pair.candidates->matches();
  for (PointMatch& match : matches) {
    match.a_m *= static_cast<float>(rig.scales[pair.first]);
    match.b_m *= static_cast<float>(rig.scales[pair.second]);
  }
  return matches;
}

PairState state_in(const ScaledRig& rig, const RigPair& pair) {
  const RefinedSensor &a = rig.sensors[pair.first], &b = rig.sensors[pair.second];
  return {a.origin_from_sensor.inverse() * b.origin_from_sensor, a.correction, b.correction};
}

struct Reaches {
  float still_m, moving_m;
};

/// All that a pair says about its poses and scales.
PairEquations equations_of(const RigPair& pair, const DepthSurface& a, const DepthSurface& b,
                           ScaledRig& rig, const Reaches& reach, const DepthScaleOptions& options,
                           const ResidualOptions& residuals) {
  const PairCandidates& candidates = *pair.candidates;
  const PairState state = state_in(rig, pair);
  SurfaceResidualOptions still = residuals.surfaces;
  still.max_independent = options.independent_surfaces;
  still.max_noise = 3;
  const auto partners =
      surface_partners(a, b, state.a_from_b, {reach.still_m, options.points}, still);
  PairEquations sum =
      surface_equations(partners, state.a_from_b, surface_noise(partners, still), still);

  const ColorPicture &picture_a = candidates.a().picture, &picture_b = candidates.b().picture;
  const auto agreeing =
      agreeing_matches(corrected_matches(scaled_matches(pair, rig), picture_a, picture_b, state),
                       state.a_from_b, reach.still_m);
  const double features =
      std::max(options.independent_features, static_cast<double>(agreeing.size()));
  sum.add(feature_equations(
      picture_a, picture_b, state, agreeing,
      {feature_sigma_px(picture_a, picture_b, state, agreeing, residuals.features),
       options.independent_features / features},
      residuals.features));

  const MovingPartners moving = moving_partners(
      candidates.a(), rig.scales[pair.first], candidates.b(), rig.scales[pair.second],
      state.a_from_b, reach.moving_m, options.moving, candidates.options().moving);
  SurfaceResidualOptions of_moving = residuals.surfaces;
  of_moving.max_independent = moving.independent;
  if (!moving.partners.empty())
    sum.add(surface_equations(moving.partners, state.a_from_b, kUsualNoise, of_moving));
  rig.moving[pair.first] += moving.independent;
  rig.moving[pair.second] += moving.independent;
  return sum;
}

RigEquations all_equations(std::span<const RigPair> pairs, std::size_t origin, ScaledRig& rig,
                           const Reaches& reach, const DepthScaleOptions& options,
                           const ResidualOptions& residuals) {
  const auto surfaces = scaled_surfaces(pairs, rig);
  std::fill(rig.moving.begin(), rig.moving.end(), 0.0);
  RigEquations sum(rig.sensors.size(), origin);
  for (const RigPair& pair : pairs)
    sum.add(pair.first, pair.second, rig.sensors[pair.first].origin_from_sensor,
            equations_of(pair, surfaces.at(pair.first), surfaces.at(pair.second), rig, reach,
                         options, residuals));
  for (std::size_t i = 0; i < rig.sensors.size(); ++i) {
    sum.add_prior(i, rig.sensors[i].correction, residuals.color_shift);
    sum.free_depth_scale(i, rig.scales[i] - 1, options.sigma);
  }
  return sum;
}

void move(const RigEquations& equations, ScaledRig& rig) {
  const auto steps = equations.solve();
  for (std::size_t i = 0; i < rig.sensors.size(); ++i) {
    rig.sensors[i].origin_from_sensor =
        step_transform(steps[i].head<6>()) * rig.sensors[i].origin_from_sensor;
    rig.sensors[i].correction.color_shift_px += steps[i].segment<2>(6 + kShift);
    rig.scales[i] *= 1 + steps[i](6 + kDepth + 1);
  }
}

/// The estimate, if it is determined and more likely than a sensor without an error: a calibrated
/// one's factor is 1, others' are spread by the prior (Bayes factor of both).
DepthScale accepted(double estimate, double standard_error, double moving,
                    const DepthScaleOptions& options) {
  if (moving < options.min_moving || standard_error > options.max_standard_error) return {};
  const double spread = std::hypot(options.sigma, standard_error);
  const double at_one = options.calibrated / standard_error *
                        std::exp(-0.5 * std::pow((estimate - 1) / standard_error, 2));
  const double elsewhere =
      (1 - options.calibrated) / spread * std::exp(-0.5 * std::pow((estimate - 1) / spread, 2));
  return {elsewhere > at_one ? estimate : 1, standard_error};
}

}  // namespace

std::vector<DepthScale> estimate_depth_scales(std::span<const RefinedSensor> sensors,
                                              std::size_t origin, std::span<const RigPair> pairs,
                                              const DepthScaleOptions& options,
                                              const ResidualOptions& residuals) {
  ScaledRig rig{{sensors.begin(), sensors.end()},
                std::vector<double>(sensors.size(), 1.0),
                std::vector<double>(sensors.size())};
  Reaches reach{options.reach_m, options.moving_reach_m};
  for (int i = 0; i < options.steps; ++i) {
    move(all_equations(pairs, origin, rig, reach, options, residuals), rig);
    reach.still_m = std::max(options.min_reach_m, options.shrink * reach.still_m);
    reach.moving_m = std::max(options.min_moving_reach_m, options.shrink * reach.moving_m);
  }
  const auto variances =
      all_equations(pairs, origin, rig, reach, options, residuals).depth_scale_variances();
  std::vector<DepthScale> found(sensors.size());
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (i != origin)
      found[i] = accepted(rig.scales[i], std::sqrt(variances[i]), rig.moving[i], options);
  }
  return found;
}

}  // namespace roomcast::alignment
