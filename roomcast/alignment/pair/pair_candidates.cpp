// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/pair_candidates.h"

#include <algorithm>
#include <utility>

#include "roomcast/alignment/pair/corrected_matches.h"
#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/pair/shape_hypotheses.h"

namespace roomcast::alignment {
namespace {

constexpr float kInlier_m = 0.07F;
constexpr std::size_t kMaxCandidates = 12;

// The score. Its unit is the weight of one unique match.
constexpr double kMaxMatchScore = 60;
constexpr double kViolationScore = 300, kForgivenConflict = 0.03;
constexpr double kSolidScore = 1;  // per violating block
constexpr double kPhotoScore = 1500, kNeutralCorrelation = 0.35, kMaxPhotoScore = 60;

// Limits: a pose beyond them is refuted, whatever its matches.
constexpr double kMaxConflict = 0.12, kNegligibleViolation = 0.01;
constexpr double kRefuted = -15;
constexpr double kMinTextured = 0.01;

constexpr double kStrongSupport = 8, kStrongOverlap = 0.03;
// At large viewing angles few features match well. Many places that agree weakly then count too, if
// all other evidence supports the pose.
constexpr double kFaintSupport = 3.5, kFaintScore = 20;
constexpr int kFaintCells = 20;
constexpr double kPooledScore = 40;
constexpr double kStrongCorrelation = 0.40, kStrongTextured = 0.004;

/// For colour slightly misaligned with depth, and for views so far apart that hardly any match is
/// right. This vote also finds rivals, so it is used only for pairs without a plausible candidate.
constexpr VoteOptions kCoarseVote{4000, 400, 24, 0.1F, 0.04F};

constexpr double kMinSupportKept = 0.5;  // share of the match weight that refinement must keep
constexpr double kMaxRefinedShift_m = 0.3;

bool violates_space(const FreeSpaceCheck& space) {
  return space.conflict() > kMaxConflict && space.violating > kNegligibleViolation;
}

double photo_score(const PhotoConsistency& photo) {
  return kPhotoScore * photo.textured * (photo.correlation - kNeutralCorrelation);
}

double score_of(const PoseEvidence& evidence) {
  const FreeSpaceCheck& space = evidence.space;
  const PhotoConsistency& photo = evidence.photo;
  double score = std::min(evidence.matches.weight, kMaxMatchScore);
  score -=
      kViolationScore *
      std::max(0.0, space.violating - kForgivenConflict * (space.consistent + space.violating));
  score -= kSolidScore * static_cast<double>(evidence.solid.violating);
  score += std::clamp(photo_score(photo), -kMaxPhotoScore, kMaxPhotoScore);
  if (violates_space(space)) score = std::min(score, 0.0) + kRefuted;
  const bool looks_different =
      photo.textured > kMinTextured && photo.correlation < kNeutralCorrelation;
  return looks_different ? std::min(score, 0.0) : score;
}

}  // namespace

bool is_strong(const PoseEvidence& evidence) {
  const bool faintly_supported = evidence.matches.weight >= kFaintSupport &&
                                 evidence.matches.cells >= kFaintCells &&
                                 evidence.score >= kFaintScore;
  return (evidence.matches.weight >= kStrongSupport || faintly_supported) &&
         evidence.space.consistent > kStrongOverlap && evidence.space.conflict() <= kMaxConflict &&
         evidence.photo.correlation > kStrongCorrelation &&
         evidence.photo.textured > kStrongTextured;
}

bool fits_better(const PoseEvidence& one, const PoseEvidence& other) {
  if (one.score <= 0 || other.score <= 0) return one.score > other.score;
  const auto beyond = [](const PoseEvidence& evidence) {
    return std::max(0.0, photo_score(evidence.photo) - kMaxPhotoScore);
  };
  return one.score + beyond(one) > other.score + beyond(other);
}

void PooledEvidence::add(const PoseEvidence& evidence) {
  support += evidence.matches.weight;
  score += evidence.score;
  textured += evidence.photo.textured;
  correlated += evidence.photo.textured * evidence.photo.correlation;
  cells += evidence.matches.cells;
}

bool is_strong(const PooledEvidence& evidence) {
  return evidence.support >= kFaintSupport && evidence.cells >= kFaintCells &&
         evidence.score >= kPooledScore && evidence.textured > kStrongTextured &&
         evidence.correlated > kStrongCorrelation * evidence.textured;
}

PairCandidates::PairCandidates(const SensorView& a, const SensorView& b,
                               std::vector<PointMatch> matches)
    : a_(&a), b_(&b), matches_(std::move(matches)) {
  if (same_pictures()) return;
  rank(vote_for_poses(matches_), ColorCalibration::kAsCalibrated);
  if (!is_conclusive())
    rank(hypotheses_by_shape(a_->surface, b_->surface), ColorCalibration::kAsCalibrated);
  if (!has_plausible()) rank(vote_for_poses(matches_, kCoarseVote), ColorCalibration::kUncertain);
}

void PairCandidates::add_affine_matches(const std::vector<PointMatch>& more) {
  matches_.insert(matches_.end(), more.begin(), more.end());
  std::vector<PoseEvidence> known;
  for (const PoseEvidence& each : ranked_)
    known.push_back(examine({each.a_from_b, each.correction_a, each.correction_b}));
  keep_best(std::move(known));
  rank(vote_for_poses(matches_), ColorCalibration::kAsCalibrated);
  if (!has_plausible()) rank(vote_for_poses(matches_, kCoarseVote), ColorCalibration::kUncertain);
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
          return are_rivals(candidate.a_from_b, better.a_from_b);
        });
    if (is_new && ranked_.size() < kMaxCandidates) ranked_.push_back(candidate);
  }
}

bool PairCandidates::is_conclusive() const {
  return !ranked_.empty() && is_strong(ranked_[0]) && margin() > kMinMargin;
}

bool PairCandidates::has_plausible() const {
  return std::ranges::any_of(ranked_, [](const PoseEvidence& each) {
    return is_strong(each) && each.score > kPoseCost + kMinMargin;
  });
}

const PoseEvidence* PairCandidates::nearest(const RigidTransform& a_from_b) const {
  const auto found = std::ranges::find_if(
      ranked_, [&](const PoseEvidence& known) { return !are_rivals(known.a_from_b, a_from_b); });
  return found == ranked_.end() ? nullptr : &*found;
}

double PairCandidates::margin() const {
  if (ranked_.empty()) return 0;
  return ranked_.size() == 1 ? ranked_[0].score : ranked_[0].score - ranked_[1].score;
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
  evidence.matches = match_support(agreeing_matches(
      corrected_matches(matches_, a_->picture, b_->picture, state), a_from_b, kInlier_m));
  evidence.space = check_free_space(a_->surface, b_->surface, a_from_b, kTestedPoints);
  if (!violates_space(evidence.space)) {
    evidence.solid = check_solid_conflict(a_->surface, b_->surface, a_from_b);
    evidence.photo = check_photo_consistency(*a_, *b_, state);
  }
  evidence.score = score_of(evidence);
  return evidence;
}

/// Refines a hypothesis and returns the better of start and result, because surfaces alone let a
/// pose slide along floors and walls.
PoseEvidence PairCandidates::settled(const PoseHypothesis& hypothesis,
                                     ColorCalibration color) const {
  const RigidTransform& start = hypothesis.a_from_b;
  const PairState moved = refined_pose(*a_, *b_, matches_, start, color);
  const PoseEvidence before = examine(start);
  if (difference(moved.a_from_b, start, Eigen::Vector3d::Zero()).distance_m > kMaxRefinedShift_m)
    return before;
  const PoseEvidence after = examine(moved);
  if (after.matches.weight < kMinSupportKept * before.matches.weight) return before;
  return fits_better(after, before) ? after : before;
}

}  // namespace roomcast::alignment
