// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/placed_rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace roomcast::alignment {
namespace {

const Eigen::Vector3d kInView_m(0, 0, 2.5);

/// Whether the pair takes part in refinement. Wrong lenses displace features, not what moves.
bool holds(const PoseEvidence& evidence, const RigOptions& rig) {
  const PlacingOptions& options = rig.placing;
  if (is_strong(evidence, rig.pair.evidence)) return true;
  const bool moves_alike =
      evidence.moving_agreement >= rig.pair.evidence.moving_agrees &&
      static_cast<double>(evidence.solid.consistent) >= rig.contradiction.vouching_solid;
  return (evidence.matches.weight >= options.holding_support ||
          evidence.score >= options.holding_score || moves_alike) &&
         evidence.space.consistent > options.holding_overlap &&
         evidence.space.conflict() <= options.holding_conflict;
}

std::vector<bool> placed_sensors(const PoseSelection& selection, double min_margin) {
  const std::size_t count = selection.best.group.size();
  std::vector<bool> placed(count);
  bool any = false;
  for (std::size_t i = 0; i < count; ++i) {
    placed[i] = i != selection.origin && selection.best.together(i, selection.origin) &&
                selection.margin_to_rival[i] > min_margin &&
                selection.margin_to_unplaced[i] > min_margin;
    any = any || placed[i];
  }
  placed[selection.origin] = any || count == 1;
  return placed;
}

std::vector<RigPair> usable_pairs(std::span<const RigPair> pairs, const std::vector<bool>& placed,
                                  const std::vector<RigidTransform>& origin_from_sensor,
                                  const RigOptions& options) {
  std::vector<RigPair> holding;
  for (const RigPair& pair : pairs) {
    if (!placed[pair.first] || !placed[pair.second]) continue;
    const RigidTransform a_from_b =
        origin_from_sensor[pair.first].inverse() * origin_from_sensor[pair.second];
    if (holds(pair.candidates->examine(a_from_b), options)) holding.push_back(pair);
  }
  return holding;
}

/// Median distance between the surfaces that both see.
double residual_mm(const PairCandidates& pair, const RigidTransform& a_from_b,
                   const RigOptions& options) {
  const SurfaceReach reach{options.placing.reported_reach_m, options.placing.reported_points};
  std::vector<float> residuals_m;
  for (const SurfacePartner& partner : surface_partners(
           pair.a().surface, pair.b().surface, a_from_b, reach, options.pair.residuals.surfaces)) {
    residuals_m.push_back(std::abs(partner.residual_m));
  }
  if (residuals_m.empty()) return 0;
  const auto middle = residuals_m.begin() + static_cast<std::ptrdiff_t>(residuals_m.size() / 2);
  std::nth_element(residuals_m.begin(), middle, residuals_m.end());
  return 1000.0 * double(*middle);
}

PairReport empty_report(const PairCandidates& candidates) {
  PairReport report;
  report.a = candidates.a().name;
  report.b = candidates.b().name;
  report.margin = candidates.margin();
  return report;
}

void describe(const PoseEvidence& evidence, PairReport& report) {
  report.overlap = evidence.space.min_consistent;
  report.inliers = evidence.matches.cells;
  report.conflict = evidence.space.conflict();
  report.correlation = evidence.photo.correlation;
}

/// `before` is the evidence on which the pair was accepted, with calibrations as given.
PairReport report_placed(const RigPair& pair, const PoseEvidence& before,
                         const RigidTransform& a_from_b, const RigOptions& options) {
  const EvidenceOptions& limits = options.pair.evidence;
  const PairCandidates& candidates = *pair.candidates;
  const PoseEvidence evidence = candidates.examine(a_from_b);
  PairReport report = empty_report(candidates);
  describe(evidence, report);
  report.correlation = std::max(before.photo.correlation, evidence.photo.correlation);
  report.b_from_a = a_from_b.inverse();
  report.residual_mm = residual_mm(candidates, a_from_b, options);
  report.accepted = is_strong(before, limits) || is_strong(evidence, limits);
  report.reason = report.accepted ? fmt::format("{} places agree, colours correlate by {:.2f}",
                                                report.inliers, report.correlation)
                                  : why_pair_says_little(candidates, evidence, options.refusal);
  return report;
}

/// Whether the pair's relative pose is known, but not its pose in the world.
bool is_separate_group(const RigPair& pair, const PoseSelection& selection) {
  return selection.best.together(pair.first, pair.second) &&
         !selection.best.together(pair.first, selection.origin);
}

PairReport report_refused(const RigPair& pair, const RigAnswer& answer,
                          const RefusalOptions& options) {
  const PairCandidates& candidates = *pair.candidates;
  PairReport report = empty_report(candidates);
  if (!candidates.ranked().empty()) describe(candidates.ranked()[0], report);
  report.reason = why_pair_is_refused(candidates, options);
  if (!report.reason.empty()) return report;
  if (answer.is_unheld(pair)) {
    report.reason = fmt::format(
        "{} and {} match, but their surfaces do not meet at any pose: lenses or depth are off; "
        "measure them with roomcast calibrate, or let somebody walk through both views",
        report.a, report.b);
    return report;
  }
  report.reason = is_separate_group(pair, answer.selection)
                      ? fmt::format(
                            "{} and {} fit together, but neither fits the sensors that are placed; "
                            "turn one of them so that it shares more with those",
                            report.a, report.b)
                      : fmt::format("the relative pose of {} and {} contradicts other pairs",
                                    report.a, report.b);
  return report;
}

/// Variance of a point 2.5 m ahead of `of`, caused by the pose uncertainty of `sensor`.
double variance_at_view_m2(const RefinedSensor& sensor, const RefinedSensor& of) {
  const auto by_motion = point_motion(of.origin_from_sensor * kInView_m);
  return (by_motion * sensor.covariance * by_motion.transpose()).trace();
}

/// Variance caused by both sensors' pointing errors, at the distance of the scene.
double variance_of_pointing_m2(double sigma_rad) {
  return 2 * sigma_rad * sigma_rad * kInView_m.squaredNorm();
}

/// Both errors are 0 for the origin, by definition, and for a sensor that no pair constrains.
void describe_error(const RefinedSensor& sensor, double pointing_sigma_rad, SensorReport& report) {
  if (sensor.covariance.isZero()) return;
  const double pointing = pointing_sigma_rad * pointing_sigma_rad;  // of each axis
  const double at_view_m2 =
      variance_at_view_m2(sensor, sensor) + variance_of_pointing_m2(pointing_sigma_rad);
  const double turn_rad2 = sensor.covariance.topLeftCorner<3, 3>().trace() + 3 * pointing;
  report.expected_error_mm = 1000 * std::sqrt(std::max(0.0, at_view_m2));
  report.expected_error_deg = std::sqrt(std::max(0.0, turn_rad2)) * 180 / std::numbers::pi;
}

/// The reason of the sensor's pair with most inliers.
std::string why_sensor_is_apart(const std::string& name, const std::vector<PairReport>& pairs) {
  const PairReport* nearest = nullptr;
  for (const PairReport& pair : pairs) {
    if (pair.a != name && pair.b != name) continue;
    if (!nearest || pair.inliers > nearest->inliers) nearest = &pair;
  }
  return nearest ? nearest->reason : "there is no other sensor to align it with";
}

/// origin_from_sensor of each sensor.
std::vector<RigidTransform> refined_poses(const RigAnswer& answer) {
  std::vector<RigidTransform> poses;
  for (const RefinedSensor& sensor : answer.refined) poses.push_back(sensor.origin_from_sensor);
  return poses;
}

/// Refines all placed sensors at once, over all pairs of them with sufficient evidence at the given
/// poses. Sensors with factors on their readings are known not to be calibrated.
void refine(std::span<const RigPair> pairs, const std::vector<RigidTransform>& origin_from_sensor,
            const RigOptions& options, std::span<const DepthScale> scales, RigAnswer& answer) {
  const auto usable = usable_pairs(pairs, answer.placed, origin_from_sensor, options);
  const std::size_t origin = answer.selection.origin;
  answer.refined =
      refine_rig(origin_from_sensor, origin, usable, options.refinement, options.pair.residuals);
  const bool has_factors =
      std::ranges::any_of(scales, [](const DepthScale& scale) { return scale.factor != 1; });
  if (has_factors) {
    for (RefinedSensor& sensor : answer.refined) sensor.uncalibrated_belief = 1;
  }
}

/// Refines sensors that are not calibrated by all evidence, also by what moves. Returns whether
/// they are.
bool refine_jointly(std::span<const RigPair> pairs, const RigOptions& options,
                    std::span<const DepthScale> scales, RigAnswer& answer) {
  const std::size_t origin = answer.selection.origin;
  if (answer.refined[origin].uncalibrated_belief < options.placing.uncalibrated) return false;
  refine_uncalibrated(origin, usable_pairs(pairs, answer.placed, refined_poses(answer), options),
                      scales, options.depth_scales, options.pair.residuals, answer.refined);
  return true;
}

/// Refines again from the refined poses, where other matches agree than at the start.
void refine_again(std::span<const RigPair> pairs, const RigOptions& options,
                  std::span<const DepthScale> scales, RigAnswer& answer) {
  refine(pairs, refined_poses(answer), options, scales, answer);
}

RigAnswer answer_of(std::size_t sensors, std::span<const RigPair> pairs, const RigOptions& options,
                    std::span<const DepthScale> scales) {
  // 1. Select the hypotheses that fit together, and the sensors without a rival pose.
  RigAnswer answer;
  answer.selection =
      select_poses(sensors, pairs, options.selection, options.pair.rivals, options.pair.evidence);
  answer.placed = placed_sensors(answer.selection, options.pair.evidence.min_margin);

  // 2. Refine them jointly.
  refine(pairs, answer.selection.best.group_from_sensor, options, scales, answer);
  return answer;
}

/// The answer, refined jointly if its sensors are not calibrated and that does not contradict what
/// they see; else with the errors of the joint refinement only. Nothing if neither can be true.
std::optional<RigAnswer> uncontradicted(std::span<const RigPair> pairs, const RigAnswer& answer,
                                        bool contradicted, const RigOptions& options,
                                        std::span<const DepthScale> scales, RigCheck& check) {
  RigAnswer joint = answer;
  const bool is_uncalibrated = refine_jointly(pairs, options, scales, joint);
  if (is_uncalibrated && !check.contradicted_sensor(pairs, joint)) return joint;
  if (contradicted) return std::nullopt;
  RigAnswer kept = answer;
  if (is_uncalibrated) {
    for (std::size_t i = 0; i < kept.refined.size(); ++i)
      kept.refined[i].covariance = joint.refined[i].covariance;
  }
  return kept;
}

/// Which sensors pairs connect with the origin.
std::vector<bool> connected_with(std::size_t origin, std::size_t sensors,
                                 std::span<const RigPair> pairs) {
  std::vector<bool> connected(sensors);
  connected[origin] = true;
  for (bool grows = true; grows;) {
    grows = false;
    for (const RigPair& pair : pairs) {
      if (connected[pair.first] == connected[pair.second]) continue;
      connected[pair.first] = connected[pair.second] = grows = true;
    }
  }
  return connected;
}

/// Takes sensors out of the answer whose refined poses no pair holds: nothing is known of their
/// errors. Lenses or depth that are off make that of poses which were selected for good reasons.
void release_unheld(std::span<const RigPair> pairs, const RigOptions& options, RigAnswer& answer) {
  const std::size_t origin = answer.selection.origin, sensors = answer.placed.size();
  std::vector<bool> held = connected_with(
      origin, sensors, usable_pairs(pairs, answer.placed, refined_poses(answer), options));
  for (std::size_t i = 0; i < sensors; ++i)
    if (answer.refined[i].covariance.isZero()) held[i] = false;
  answer.unheld.assign(sensors, false);
  bool any = false;
  for (std::size_t i = 0; i < sensors; ++i) {
    if (i == origin || !answer.placed[i]) continue;
    answer.unheld[i] = !held[i];
    answer.placed[i] = held[i];
    any = any || held[i];
  }
  if (sensors > 1) answer.placed[origin] = any;
}

/// Solves until the answer does not contradict itself. The most contradicted sensor is removed each
/// time, and the rest is solved again, because it must be valid on its own.
RigAnswer answer_without_contradiction(std::size_t sensors, std::span<const RigPair> pairs,
                                       const RigOptions& options,
                                       std::span<const DepthScale> scales) {
  std::vector<RigPair> left(pairs.begin(), pairs.end());
  RigCheck check(options.contradiction);
  for (;;) {
    RigAnswer answer = answer_of(sensors, left, options, scales);
    auto fooled = check.contradicted_sensor(left, answer);
    if (fooled) {
      refine_again(left, options, scales, answer);  // the poses may not be exact yet
      fooled = check.contradicted_sensor(left, answer);
    }
    auto found = uncontradicted(left, answer, fooled.has_value(), options, scales, check);
    if (found) {
      release_unheld(left, options, *found);
      return *std::move(found);
    }
    std::erase_if(
        left, [&](const RigPair& pair) { return pair.first == *fooled || pair.second == *fooled; });
  }
}

WorldFrame world_of(std::span<const SensorView* const> views, const RigAnswer& answer,
                    const WorldFrameOptions& options) {
  std::vector<Plane> floors;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (answer.placed[i] && views[i]->floor)
      floors.push_back(transformed(answer.refined[i].origin_from_sensor, *views[i]->floor));
  }
  return world_frame(floors, options);
}

PairReport report_of(const RigPair& pair, const RigAnswer& answer, const RigOptions& options) {
  if (!answer.placed[pair.first] || !answer.placed[pair.second])
    return report_refused(pair, answer, options.refusal);
  const RigidTransform selected = answer.selection.best.relative(pair.first, pair.second);
  PairReport report =
      report_placed(pair, pair.candidates->examine(selected), answer.relative(pair), options);
  const RefinedSensor &a = answer.refined[pair.first], &b = answer.refined[pair.second];
  report.expected_error_mm =
      1000 * std::sqrt(std::max(0.0, variance_at_view_m2(a, b)) +
                       std::max(0.0, variance_at_view_m2(b, b)) +
                       variance_of_pointing_m2(options.placing.pointing_sigma_rad));
  return report;
}

/// Fills in the statistics of the sensor's pairs.
void describe_pairs(const std::vector<PairReport>& pairs, SensorReport& report) {
  double sum = 0, shared = 0;
  for (const PairReport& pair : pairs) {
    if (!pair.b_from_a || (pair.a != report.id && pair.b != report.id)) continue;
    report.overlap = std::max(report.overlap, pair.overlap);
    report.inliers += pair.inliers;
    sum += pair.overlap * pair.residual_mm;
    shared += pair.overlap;
  }
  if (shared > 0) report.residual_mm = sum / shared;
}

SensorReport report_of(std::size_t index, const std::string& name, const RigAnswer& answer,
                       const WorldFrame& world, const std::vector<PairReport>& pairs,
                       double pointing_sigma_rad) {
  SensorReport report;
  report.id = name;
  report.placed = answer.placed[index];
  if (!report.placed) {
    report.reason = why_sensor_is_apart(name, pairs);
    return report;
  }
  const RefinedSensor& refined = answer.refined[index];
  report.world_from_depth = world.world_from_origin * refined.origin_from_sensor;
  describe_error(refined, pointing_sigma_rad, report);
  describe_pairs(pairs, report);
  report.correction = refined.correction;
  report.reason = index == answer.selection.origin ? "stands at the origin" : "placed";
  return report;
}

/// Of the placed sensors whose scales are compared: all, where no factor is determined.
double scale_error_of(const RigAnswer& answer, std::span<const DepthScale> scales,
                      double uncalibrated_belief, const DepthScaleOptions& options) {
  std::size_t placed = 0, determined = 0;
  double belief = uncalibrated_belief;
  for (std::size_t i = 0; i < answer.placed.size(); ++i) {
    if (!answer.placed[i]) continue;
    ++placed;
    if (i >= scales.size() || !(scales[i].standard_error > 0)) continue;
    ++determined;
    if (scales[i].factor == 1) belief = 0;  // a calibrated one has the true scale
  }
  if (placed < 2) return 0;
  return common_scale_error(determined > 0 ? determined + 1 : placed, belief,
                            options.fit.scale_sigma, options.common);
}

}  // namespace

std::vector<DepthScale> rig_depth_scales(std::size_t sensors, std::span<const RigPair> pairs,
                                         const RigOptions& options) {
  const RigAnswer answer = answer_of(sensors, pairs, options, {});
  std::vector<RigPair> of_placed;
  for (const RigPair& pair : pairs) {
    if (answer.placed[pair.first] && answer.placed[pair.second]) of_placed.push_back(pair);
  }
  return estimate_depth_scales(answer.refined, answer.selection.origin, of_placed,
                               options.depth_scales, options.pair.residuals);
}

AlignmentReport place_rig(std::span<const SensorView* const> views, std::span<const RigPair> pairs,
                          const RigOptions& options, std::span<const DepthScale> scales) {
  AlignmentReport report;
  if (views.empty()) return report;
  const RigAnswer answer = answer_without_contradiction(views.size(), pairs, options, scales);
  const WorldFrame world = world_of(views, answer, options.world_frame);
  report.has_floor = world.has_floor;
  for (const RigPair& pair : pairs) report.pairs.push_back(report_of(pair, answer, options));
  for (std::size_t i = 0; i < views.size(); ++i)
    report.sensors.push_back(report_of(i, views[i]->name, answer, world, report.pairs,
                                       options.placing.pointing_sigma_rad));
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (answer.placed[i])
      report.uncalibrated_belief =
          std::max(report.uncalibrated_belief, answer.refined[i].uncalibrated_belief);
  }
  report.scale_error =
      scale_error_of(answer, scales, report.uncalibrated_belief, options.depth_scales);
  return report;
}

}  // namespace roomcast::alignment
