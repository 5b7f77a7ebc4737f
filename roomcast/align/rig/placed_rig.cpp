// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/rig/placed_rig.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "roomcast/align/pair/surface_residuals.h"
#include "roomcast/align/rig/refusal.h"
#include "roomcast/align/rig/rig_refinement.h"
#include "roomcast/align/rig/world_frame.h"

namespace roomcast::align {
namespace {

constexpr double kHoldingSupport = 6, kHoldingOverlap = 0.03, kHoldingConflict = 0.12;
constexpr double kRefinedConflict = 0.0275, kNegligibleViolation = 0.004;
constexpr SurfaceReach kReported{0.05F, 20'000};
const Eigen::Vector3d kInView_m(0, 0, 2.5);

/// Whether a pair has enough to say, where its sensors stand now, to take part in refinement.
bool holds(const PoseEvidence& evidence) {
  if (is_strong(evidence)) return true;
  return evidence.matches.weight >= kHoldingSupport &&
         evidence.space.consistent > kHoldingOverlap &&
         evidence.space.conflict() <= kHoldingConflict;
}

std::vector<bool> placed_sensors(const PoseSelection& selection) {
  const std::size_t count = selection.best.group.size();
  std::vector<bool> placed(count);
  bool any = false;
  for (std::size_t i = 0; i < count; ++i) {
    placed[i] = i != selection.origin && selection.best.together(i, selection.origin) &&
                selection.margin_to_rival[i] > kLeastMargin &&
                selection.margin_to_unplaced[i] > kLeastMargin;
    any = any || placed[i];
  }
  placed[selection.origin] = any || count == 1;
  return placed;
}

/// Refined poses are exact, so what they contradict now is held against them more strictly.
bool contradicts(const PoseEvidence& refined) {
  return refined.space.conflict() > kRefinedConflict &&
         refined.space.violating > kNegligibleViolation;
}

/// Takes out sensors whose refined place contradicts what others see: of each such pair the one
/// that was less sure.
void drop_contradicted(std::span<const RigPair> pairs, std::span<const RefinedSensor> refined,
                       const PoseSelection& selection, std::vector<bool>& placed) {
  const auto margin = [&](std::size_t i) {
    return std::min(selection.margin_to_rival[i], selection.margin_to_unplaced[i]);
  };
  for (const RigPair& pair : pairs) {
    const auto [a, b, candidates] = pair;
    if (!placed[a] || !placed[b]) continue;
    const RigidTransform a_from_b =
        refined[a].origin_from_sensor.inverse() * refined[b].origin_from_sensor;
    if (!contradicts(candidates->examine(a_from_b))) continue;
    const bool drop_a = a != selection.origin && margin(a) < margin(b);
    placed[drop_a ? a : b] = false;
  }
  if (std::count(placed.begin(), placed.end(), true) == 1) placed[selection.origin] = false;
}

std::vector<RigPair> holding_pairs(std::span<const RigPair> pairs, const std::vector<bool>& placed,
                                   const std::vector<RigidTransform>& origin_from_sensor) {
  std::vector<RigPair> holding;
  for (const RigPair& pair : pairs) {
    if (!placed[pair.first] || !placed[pair.second]) continue;
    const RigidTransform a_from_b =
        origin_from_sensor[pair.first].inverse() * origin_from_sensor[pair.second];
    if (holds(pair.candidates->examine(a_from_b))) holding.push_back(pair);
  }
  return holding;
}

/// Median distance between the surfaces that both see.
double residual_mm(const PairCandidates& pair, const RigidTransform& a_from_b) {
  std::vector<float> residuals_m;
  for (const SurfacePartner& partner :
       surface_partners(pair.a().surface, pair.b().surface, a_from_b, kReported)) {
    residuals_m.push_back(std::abs(partner.residual_m));
  }
  if (residuals_m.empty()) return 0;
  const auto middle = residuals_m.begin() + static_cast<std::ptrdiff_t>(residuals_m.size() / 2);
  std::nth_element(residuals_m.begin(), middle, residuals_m.end());
  return 1000.0 * double(*middle);
}

PairReport report_of(const PairCandidates& candidates) {
  PairReport report;
  report.a = candidates.a().name;
  report.b = candidates.b().name;
  report.margin = candidates.margin();
  return report;
}

void describe(const PoseEvidence& evidence, PairReport& report) {
  report.overlap = evidence.space.consistent_least;
  report.inliers = evidence.matches.cells;
  report.conflict = evidence.space.conflict();
  report.correlation = evidence.photo.correlation;
}

/// `before` is the evidence that the pair was believed on, with calibrations as given.
PairReport report_placed(const RigPair& pair, const PoseEvidence& before,
                         const RigidTransform& a_from_b) {
  const PairCandidates& candidates = *pair.candidates;
  const PoseEvidence evidence = candidates.examine(a_from_b);
  PairReport report = report_of(candidates);
  describe(evidence, report);
  report.correlation = std::max(before.photo.correlation, evidence.photo.correlation);
  report.b_from_a = a_from_b.inverse();
  report.residual_mm = residual_mm(candidates, a_from_b);
  report.accepted = is_strong(before) || is_strong(evidence);
  report.reason = report.accepted ? fmt::format("{} places agree, colours correlate by {:.2f}",
                                                report.inliers, report.correlation)
                                  : why_pair_says_little(candidates, evidence);
  return report;
}

PairReport report_refused(const RigPair& pair) {
  const PairCandidates& candidates = *pair.candidates;
  PairReport report = report_of(candidates);
  if (!candidates.ranked().empty()) describe(candidates.ranked()[0], report);
  report.reason = why_pair_is_refused(candidates);
  if (report.reason.empty()) {
    report.reason =
        fmt::format("what {} and {} see of each other contradicts other pairs", report.a, report.b);
  }
  return report;
}

double expected_error_mm(const RefinedSensor& sensor) {
  const Eigen::Vector3d at = sensor.origin_from_sensor * kInView_m;
  Eigen::Matrix<double, 3, 6> by_motion;
  by_motion << 0, at.z(), -at.y(), 1, 0, 0,  //
      -at.z(), 0, at.x(), 0, 1, 0,           //
      at.y(), -at.x(), 0, 0, 0, 1;
  const Eigen::Matrix3d spread = by_motion * sensor.covariance * by_motion.transpose();
  return 1000 * std::sqrt(std::max(0.0, spread.trace()));
}

/// The most telling refusal among the pairs of a sensor: of the one it shares most with.
std::string why_sensor_is_apart(const std::string& name, const std::vector<PairReport>& pairs) {
  const PairReport* nearest = nullptr;
  for (const PairReport& pair : pairs) {
    if (pair.a != name && pair.b != name) continue;
    if (!nearest || pair.inliers > nearest->inliers) nearest = &pair;
  }
  return nearest ? nearest->reason : "there is no other sensor to align it with";
}

}  // namespace

AlignmentReport place_rig(std::span<const SensorView* const> views,
                          std::span<const RigPair> pairs) {
  AlignmentReport report;
  if (views.empty()) return report;

  // 1. Which hypotheses fit together, and whose sensors have no rival place?
  const PoseSelection selection = select_poses(views.size(), pairs);
  std::vector<bool> placed = placed_sensors(selection);

  // 2. All placed sensors at once, on all that any two of them share.
  const auto& start = selection.best.group_from_sensor;
  const std::vector<RefinedSensor> refined =
      refine_rig(start, selection.origin, holding_pairs(pairs, placed, start));
  if (views.size() > 1) drop_contradicted(pairs, refined, selection, placed);

  // 3. Floor down, y up.
  std::vector<Plane> floors;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (placed[i] && views[i]->floor)
      floors.push_back(transformed(refined[i].origin_from_sensor, *views[i]->floor));
  }
  const WorldFrame world = world_frame(floors);
  report.has_floor = world.has_floor;

  // 4. What came of it.
  for (const RigPair& pair : pairs) {
    if (!placed[pair.first] || !placed[pair.second]) {
      report.pairs.push_back(report_refused(pair));
      continue;
    }
    const RefinedSensor& a = refined[pair.first];
    const RefinedSensor& b = refined[pair.second];
    report.pairs.push_back(report_placed(
        pair, pair.candidates->examine(selection.best.relative(pair.first, pair.second)),
        a.origin_from_sensor.inverse() * b.origin_from_sensor));
  }
  for (std::size_t i = 0; i < views.size(); ++i) {
    SensorReport sensor;
    sensor.id = views[i]->name;
    sensor.placed = placed[i];
    if (placed[i]) {
      sensor.world_from_depth = world.world_from_origin * refined[i].origin_from_sensor;
      sensor.expected_error_mm = expected_error_mm(refined[i]);
      sensor.correction = refined[i].correction;
      sensor.reason = i == selection.origin ? "stands at the origin" : "placed";
    } else {
      sensor.reason = why_sensor_is_apart(views[i]->name, report.pairs);
    }
    report.sensors.push_back(std::move(sensor));
  }
  return report;
}

}  // namespace roomcast::align
