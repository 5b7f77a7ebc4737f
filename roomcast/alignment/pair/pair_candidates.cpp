// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/pair_candidates.h"

#include <algorithm>
#include <utility>

#include "roomcast/alignment/pair/corrected_matches.h"

namespace roomcast::alignment {
namespace {

bool violates_space(const FreeSpaceCheck& space, const EvidenceOptions& options) {
  return space.conflict() > options.max_conflict && space.violating > options.negligible_violation;
}

double photo_score(const PhotoConsistency& photo, const EvidenceOptions& options) {
  return options.per_texture * photo.textured * (photo.correlation - options.neutral_correlation);
}

bool contradicts_motion(const MovingConsistency& moving, const EvidenceOptions& options) {
  return moving.judged() >= options.enough_moving &&
         moving.conflict() > options.max_moving_conflict;
}

double agreement_of(const MovingConsistency& moving, const EvidenceOptions& options) {
  const double enough = std::min(1.0, moving.judged() / options.enough_moving);
  return enough * (1 - 2 * moving.conflict());
}

bool is_unexplained(const MovingConsistency& moving, const EvidenceOptions& options) {
  return moving.possible >= options.enough_moving &&
         moving.judged() < options.max_explained * moving.possible;
}

bool is_look_alike(const PoseEvidence& evidence, const EvidenceOptions& options) {
  const PoseDifference apart =
      difference(evidence.a_from_b, RigidTransform(), Eigen::Vector3d::Zero());
  if (apart.angle_rad > options.same_view_rad || apart.distance_m > options.same_view_m ||
      evidence.space.min_consistent < options.same_view_overlap)
    return false;
  return evidence.matches.weight < options.same_view_matches &&
         evidence.photo.correlation < options.same_view_correlation;
}

/// Positive where what moves agrees, negative where it contradicts or is not explained.
double moving_score(const PoseEvidence& evidence, const EvidenceOptions& options) {
  double score = options.max_moving * evidence.moving_agreement;
  if (evidence.leaves_motion_unexplained) score -= options.unexplained_moving;
  return score;
}

double score_of(const PoseEvidence& evidence, const EvidenceOptions& options) {
  const FreeSpaceCheck& space = evidence.space;
  const PhotoConsistency& photo = evidence.photo;
  double score = std::min(evidence.matches.weight, options.max_matches);
  score -= options.per_violation *
           std::max(0.0, space.violating -
                             options.forgiven_conflict * (space.consistent + space.violating));
  score -= options.per_solid_block * static_cast<double>(evidence.solid.violating);
  score += std::clamp(photo_score(photo, options), -options.max_photo, options.max_photo);
  score += moving_score(evidence, options);
  if (violates_space(space, options) || contradicts_motion(evidence.moving, options) ||
      evidence.is_look_alike)
    score = std::min(score, 0.0) + options.refuted;
  const bool looks_different = evidence.moving_agreement < options.moving_agrees &&
                               photo.textured > options.min_textured &&
                               photo.correlation < options.neutral_correlation;
  return looks_different ? std::min(score, 0.0) : score;
}

}  // namespace

bool is_strong(const PoseEvidence& evidence, const EvidenceOptions& options) {
  const bool faintly_supported = evidence.matches.weight >= options.faint_support &&
                                 evidence.matches.cells >= options.faint_cells &&
                                 evidence.score >= options.faint_score;
  return (evidence.matches.weight >= options.strong_support || faintly_supported) &&
         !evidence.leaves_motion_unexplained && !evidence.is_look_alike &&
         evidence.space.consistent > options.strong_overlap &&
         evidence.space.conflict() <= options.max_conflict &&
         evidence.photo.correlation > options.strong_correlation &&
         evidence.photo.textured > options.strong_textured;
}

bool fits_better(const PoseEvidence& one, const PoseEvidence& other,
                 const EvidenceOptions& options) {
  if (one.score <= 0 || other.score <= 0) return one.score > other.score;
  const auto beyond = [&](const PoseEvidence& evidence) {
    return std::max(0.0, photo_score(evidence.photo, options) - options.max_photo);
  };
  return one.score + beyond(one) > other.score + beyond(other);
}

void PooledEvidence::add(const PoseEvidence& evidence) {
  support += evidence.matches.weight;
  score += evidence.score;
  textured += evidence.photo.textured;
  correlated += evidence.photo.textured * evidence.photo.correlation;
  cells += evidence.matches.cells;
  moving += std::max(0.0, evidence.moving_agreement);
  leaves_motion_unexplained |= evidence.leaves_motion_unexplained;
}

bool is_strong(const PooledEvidence& evidence, const EvidenceOptions& options) {
  const double correlation = evidence.moving >= options.pooled_moving ? options.moving_correlation
                                                                      : options.strong_correlation;
  if (evidence.leaves_motion_unexplained && evidence.moving < options.moving_agrees) return false;
  return evidence.support >= options.faint_support && evidence.cells >= options.faint_cells &&
         evidence.score >= options.pooled_score && evidence.textured > options.strong_textured &&
         evidence.correlated > correlation * evidence.textured;
}

PairCandidates::PairCandidates(const SensorView& a, const SensorView& b,
                               std::vector<PointMatch> matches, const PairOptions& options)
    : a_(&a), b_(&b), options_(options), matches_(std::move(matches)) {
  if (same_pictures()) return;
  rank(vote_for_poses(matches_, options_.voting, options_.support),
       ColorCalibration::kAsCalibrated);
  if (!is_conclusive())
    rank(hypotheses_by_shape(a_->surface, b_->surface, options_.shapes, options_.support),
         ColorCalibration::kAsCalibrated);
  // Always: the rivals of a pose that repeats elsewhere match no features.
  rank(hypotheses_by_motion(*a_, *b_, options_.motion, options_.moving, options_.free_space),
       ColorCalibration::kAsCalibrated);
  if (!has_plausible())
    rank(vote_for_poses(matches_, options_.coarse_voting, options_.support),
         ColorCalibration::kUncertain);
}

void PairCandidates::add_affine_matches(const std::vector<PointMatch>& more) {
  matches_.insert(matches_.end(), more.begin(), more.end());
  std::vector<PoseEvidence> known;
  for (const PoseEvidence& each : ranked_)
    known.push_back(examine({each.a_from_b, each.correction_a, each.correction_b}));
  keep_best(std::move(known));
  rank(vote_for_poses(matches_, options_.voting, options_.support),
       ColorCalibration::kAsCalibrated);
  if (!has_plausible())
    rank(vote_for_poses(matches_, options_.coarse_voting, options_.support),
         ColorCalibration::kUncertain);
}

/// Refines and scores hypotheses, and merges them into the ranking.
void PairCandidates::rank(const std::vector<PoseHypothesis>& hypotheses, ColorCalibration color) {
  std::vector<PoseEvidence> found = ranked_;
  for (const PoseHypothesis& hypothesis : hypotheses) found.push_back(settled(hypothesis, color));
  keep_best(std::move(found));
}

void PairCandidates::keep_best(std::vector<PoseEvidence> found) {
  ranked_.clear();
  std::stable_sort(found.begin(), found.end(),
                   [](const PoseEvidence& x, const PoseEvidence& y) { return x.score > y.score; });
  for (const PoseEvidence& candidate : found) {
    const bool is_new =
        std::all_of(ranked_.begin(), ranked_.end(), [&](const PoseEvidence& better) {
          return are_rivals(candidate.a_from_b, better.a_from_b, options_.rivals);
        });
    if (is_new && ranked_.size() < options_.max_candidates) ranked_.push_back(candidate);
  }
}

bool PairCandidates::is_conclusive() const {
  return !ranked_.empty() && is_strong(ranked_[0], options_.evidence) &&
         margin() > options_.evidence.min_margin;
}

bool PairCandidates::has_plausible() const {
  const EvidenceOptions& options = options_.evidence;
  return std::ranges::any_of(ranked_, [&](const PoseEvidence& each) {
    return is_strong(each, options) && each.score > options.pose_cost + options.min_margin;
  });
}

const PoseEvidence* PairCandidates::nearest(const RigidTransform& a_from_b) const {
  const auto found = std::ranges::find_if(ranked_, [&](const PoseEvidence& known) {
    return !are_rivals(known.a_from_b, a_from_b, options_.rivals);
  });
  return found == ranked_.end() ? nullptr : &*found;
}

double PairCandidates::margin() const {
  if (ranked_.empty()) return 0;
  return ranked_.size() == 1 ? ranked_[0].score : ranked_[0].score - ranked_[1].score;
}

PairCandidates::RestingMatches PairCandidates::resting_matches(const RigidTransform& one,
                                                               const RigidTransform& other) const {
  const Eigen::Matrix3f rotation_one = one.rotation.cast<float>(),
                        rotation_other = other.rotation.cast<float>();
  const Eigen::Vector3f shift_one = one.translation_m.cast<float>(),
                        shift_other = other.translation_m.cast<float>();
  RestingMatches sum;
  for (const PointMatch& match : matches_) {
    const bool by_one = distance_m(rotation_one, shift_one, match) < options_.inlier_m;
    const bool by_other = distance_m(rotation_other, shift_other, match) < options_.inlier_m;
    const auto weight = static_cast<double>(match.weight);
    if (by_one) sum.one += weight;
    if (by_other) sum.other += weight;
    if (by_one && by_other) sum.common += weight;
  }
  return sum;
}

bool PairCandidates::same_pictures() const {
  return a_->surface.z_m == b_->surface.z_m && a_->picture.grey == b_->picture.grey;
}

PoseEvidence PairCandidates::examine(const RigidTransform& a_from_b) const {
  return examine(PairState{a_from_b, {}, {}});
}

PoseEvidence PairCandidates::examine(const PairState& state) const {
  const RigidTransform& a_from_b = state.a_from_b;
  PoseEvidence evidence;
  evidence.a_from_b = a_from_b;
  evidence.correction_a = state.a;
  evidence.correction_b = state.b;
  evidence.matches =
      match_support(agreeing_matches(corrected_matches(matches_, a_->picture, b_->picture, state),
                                     a_from_b, options_.inlier_m),
                    options_.support);
  const FreeSpaceOptions& space = options_.free_space;
  evidence.space = check_free_space(a_->surface, b_->surface, a_from_b, space.points, space);
  if (!violates_space(evidence.space, options_.evidence)) {
    evidence.solid = check_solid_conflict(a_->surface, b_->surface, a_from_b, space);
    evidence.photo =
        check_photo_consistency(*a_, *b_, state, options_.photo_consistency, options_.reprojection);
  }
  evidence.moving = check_moving(*a_, *b_, a_from_b, options_.moving);
  evidence.moving_agreement = agreement_of(evidence.moving, options_.evidence);
  evidence.leaves_motion_unexplained = is_unexplained(evidence.moving, options_.evidence);
  evidence.is_look_alike = is_look_alike(evidence, options_.evidence);
  evidence.score = score_of(evidence, options_.evidence);
  return evidence;
}

/// Refines a hypothesis and returns the better of start and result, because surfaces alone let a
/// pose slide along floors and walls.
PoseEvidence PairCandidates::settled(const PoseHypothesis& hypothesis,
                                     ColorCalibration color) const {
  const RigidTransform& start = hypothesis.a_from_b;
  const PairState moved =
      refined_pose(*a_, *b_, matches_, start, color, options_.refinement, options_.residuals);
  const PoseEvidence before = examine(start);
  if (difference(moved.a_from_b, start, Eigen::Vector3d::Zero()).distance_m >
      options_.max_refined_shift_m)
    return before;
  const PoseEvidence after = examine(moved);
  if (after.matches.weight < options_.min_support_kept * before.matches.weight) return before;
  return fits_better(after, before, options_.evidence) ? after : before;
}

}  // namespace roomcast::alignment
