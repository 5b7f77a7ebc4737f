// SPDX-License-Identifier: Apache-2.0
// Pose hypotheses for a pair of sensors, ranked, each with the evidence for and against it. The
// choice among them is made later, for the whole rig. Metres. Single-threaded.
#pragma once

#include <numbers>
#include <vector>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/feature_matches.h"
#include "roomcast/alignment/pair/free_space.h"
#include "roomcast/alignment/pair/match_support.h"
#include "roomcast/alignment/pair/moving_consistency.h"
#include "roomcast/alignment/pair/moving_hypotheses.h"
#include "roomcast/alignment/pair/photo_consistency.h"
#include "roomcast/alignment/pair/planar_texture.h"
#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/pair/pose_refinement.h"
#include "roomcast/alignment/pair/shape_hypotheses.h"
#include "roomcast/alignment/pair/spatial_vote.h"

namespace roomcast::alignment {

/// Score margin by which an answer must exceed its best rival.
inline constexpr double kMinMargin = 6;

/// Score cost of each pose that an answer adds; the pose's evidence must exceed it.
inline constexpr double kPoseCost = 6;

/// How evidence becomes a score, and when it suffices. Scores are in units of one unique match's
/// weight; conflict, overlap and texture are shares. Chosen on the development rooms
/// (alignment_options.h), unless noted.
struct EvidenceOptions {
  // The score: so much for each kind of evidence, each within limits.
  double max_matches = 60;
  double per_violation = 300, forgiven_conflict = 0.03;
  double per_solid_block = 1;  // that is in the way
  double per_texture = 1500, neutral_correlation = 0.35, max_photo = 60;

  // Of what moves, agreeing or contradicting, with at least so many points; fewer count less. By
  // hand: as much as all matches.
  double max_moving = 60, enough_moving = 100;
  // Both see something moving at the same time, and this pose says that neither sees what the other
  // does: as if there were two people, and each hid from the other sensor. By hand.
  double unexplained_moving = 30, max_explained = 0.1;

  // A pose beyond these limits is refuted, whatever its matches.
  double max_conflict = 0.12;  // the prototype's: poses wrong by a floor's period exceed it
  double negligible_violation = 0.01;
  double max_moving_conflict = 0.5;  // of the points judged, if they are enough
  double refuted = -15;              // score, added
  double min_textured = 0.01;        // for colours to refute

  // Two views from nearly the same place, which share most of what they see, show the same
  // pictures: then many places match, and colours correlate. If neither is so, they are views of
  // two rooms of the same shape. In redkitchen_moving (real) all such pairs have a weight of at
  // least 31 and correlate by at least 0.66; sensors of another, simulated room of equal shelves
  // had 15 and 0.43, and with 56 % in common 19 and 0.53.
  double same_view_rad = 20 * std::numbers::pi / 180, same_view_m = 0.5, same_view_overlap = 0.5;
  double same_view_matches = 25, same_view_correlation = 0.55;

  // A pose is strong with this support, or with less at large viewing angles, where few features
  // match well: then many places must agree, if only weakly, and all other evidence with them.
  double strong_support = 8;
  double faint_support = 3.5, faint_score = 20;
  int faint_cells = 20;
  double pooled_score = 40;  // of several pairs together (ADR 12)
  double strong_overlap = 0.03;
  double strong_correlation = 0.40, strong_textured = 0.004;
  // Where what moves agrees in at least so many pairs, grazing views of common surfaces need to
  // correlate no better than this.
  double pooled_moving = 1.5, moving_correlation = 0.15;
  double moving_agrees = 0.8;  // agreement above which it does, 1 at most

  double min_margin = kMinMargin;
  double pose_cost = kPoseCost;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_matches", max_matches, Range{0, 1e6});
    visit("per_violation", per_violation, Range{0, 1e6});
    visit("forgiven_conflict", forgiven_conflict, Range{0, 1});
    visit("per_solid_block", per_solid_block, Range{0, 1e6});
    visit("per_texture", per_texture, Range{0, 1e6});
    visit("neutral_correlation", neutral_correlation, Range{-1, 1});
    visit("max_photo", max_photo, Range{0, 1e6});
    visit("max_conflict", max_conflict, Range{0, 1});
    visit("negligible_violation", negligible_violation, Range{0, 1});
    visit("max_moving", max_moving, Range{0, 1e6});
    visit("enough_moving", enough_moving, Range{1, 1e6});
    visit("unexplained_moving", unexplained_moving, Range{0, 1e6});
    visit("max_explained", max_explained, Range{0, 1});
    visit("max_moving_conflict", max_moving_conflict, Range{0, 1});
    visit("refuted", refuted, Range{-1e6, 0});
    visit("min_textured", min_textured, Range{0, 1});
    visit("same_view_rad", same_view_rad, Range{0, std::numbers::pi});
    visit("same_view_m", same_view_m, Range{0, 100});
    visit("same_view_overlap", same_view_overlap, Range{0, 1});
    visit("same_view_matches", same_view_matches, Range{0, 1e6});
    visit("same_view_correlation", same_view_correlation, Range{-1, 1});
    visit("strong_support", strong_support, Range{0, 1e6});
    visit("faint_support", faint_support, Range{0, 1e6});
    visit("faint_score", faint_score, Range{0, 1e6});
    visit("faint_cells", faint_cells, Range{0, 1e6});
    visit("pooled_score", pooled_score, Range{0, 1e6});
    visit("strong_overlap", strong_overlap, Range{0, 1});
    visit("strong_correlation", strong_correlation, Range{-1, 1});
    visit("strong_textured", strong_textured, Range{0, 1});
    visit("pooled_moving", pooled_moving, Range{0, 1e6});
    visit("moving_correlation", moving_correlation, Range{-1, 1});
    visit("moving_agrees", moving_agrees, Range{0, 1});
    visit("min_margin", min_margin, Range{0, 1e6});
    visit("pose_cost", pose_cost, Range{0, 1e6});
  }
  [[nodiscard]] Status check() const { return check_fields("EvidenceOptions", *this); }
};

struct PairOptions {
  MatchingOptions matching;
  VoteOptions voting;
  /// For colour slightly misaligned with depth, and for views so far apart that hardly any match is
  /// right. This vote also finds rivals, so it is used only for pairs without a plausible
  /// candidate.
  VoteOptions coarse_voting{.max_matches = 4000,
                            .max_seeds = 400,
                            .max_hypotheses = 24,
                            .inlier_m = 0.1F,
                            .tolerance_m = 0.04F};
  ShapeHypothesisOptions shapes;
  MovingHypothesisOptions motion;
  std::size_t max_candidates = 12;  // house3's true poses are among 12
  ResidualOptions residuals;
  PoseRefinementOptions refinement;
  double min_support_kept = 0.5;     // share of the match weight that refinement must keep; by hand
  double max_refined_shift_m = 0.3;  // from a hypothesis to its refined pose; by hand
  float inlier_m = 0.07F;            // of a match that supports a pose; by hand
  MatchSupportOptions support;
  FreeSpaceOptions free_space;
  ReprojectionOptions reprojection;
  PhotoConsistencyOptions photo_consistency;
  PlanarTextureOptions planar_texture;
  MovingConsistencyOptions moving;
  RivalOptions rivals;
  EvidenceOptions evidence;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("matching", matching);
    visit("voting", voting);
    visit("coarse_voting", coarse_voting);
    visit("shapes", shapes);
    visit("motion", motion);
    visit("max_candidates", max_candidates, Range{1, 1000});
    visit("residuals", residuals);
    visit("refinement", refinement);
    visit("min_support_kept", min_support_kept, Range{0, 1});
    visit("max_refined_shift_m", max_refined_shift_m, Range{0, 10});
    visit("inlier_m", inlier_m, Range{0.001, 10});
    visit("support", support);
    visit("free_space", free_space);
    visit("reprojection", reprojection);
    visit("photo_consistency", photo_consistency);
    visit("planar_texture", planar_texture);
    visit("moving", moving);
    visit("rivals", rivals);
    visit("evidence", evidence);
  }
  [[nodiscard]] Status check() const { return check_fields("PairOptions", *this); }
};

/// Evidence for and against a pose.
struct PoseEvidence {
  RigidTransform a_from_b;
  SensorCorrection correction_a, correction_b;  // assumed with the pose
  MatchSupport matches;
  FreeSpaceCheck space;
  SolidConflict solid;
  PhotoConsistency photo;
  MovingConsistency moving;
  double moving_agreement = 0;  // -1 (contradicts) .. 1
  /// Both see something moving at the same instants, and neither would see what the other does:
  /// half turns and shifts that move a person out of the other's view.
  bool leaves_motion_unexplained = false;
  /// Views from one place that do not show the same: of two rooms of the same shape.
  bool is_look_alike = false;
  double score = 0;  // total, in units of one unique match's weight; below 0: refuted
};

/// Whether the evidence suffices to accept the pose if no other fits as well.
[[nodiscard]] bool is_strong(const PoseEvidence& evidence, const EvidenceOptions& options = {});

/// Compares two versions of the same pose. Each kind of evidence is limited in the score, so that
/// none decides between poses alone. Of two nearly equal poses, the one with better colour
/// agreement is better.
[[nodiscard]] bool fits_better(const PoseEvidence& one, const PoseEvidence& other,
                               const EvidenceOptions& options = {});

/// Pooled evidence of several pairs for poses that follow from one another.
struct PooledEvidence {
  double support = 0, score = 0, textured = 0, correlated = 0;
  double moving = 0;                       // sum of agreements
  bool leaves_motion_unexplained = false;  // of any pair
  int cells = 0;

  void add(const PoseEvidence& evidence);
};

/// Whether pooled evidence suffices for poses of which none is strong alone.
[[nodiscard]] bool is_strong(const PooledEvidence& evidence, const EvidenceOptions& options = {});

class PairCandidates {
 public:
  /// The views must outlive this object. There are no candidates where both views have identical
  /// pictures, because one is a copy.
  PairCandidates(const SensorView& a, const SensorView& b, std::vector<PointMatch> matches,
                 const PairOptions& options = {});

  /// Re-evaluates all candidates with additional matches of affine features
  /// (feature/affine_features.h).
  void add_affine_matches(const std::vector<PointMatch>& more);

  /// Whether at least one candidate may be the answer.
  [[nodiscard]] bool has_plausible() const;

  /// Best first; any two are rivals (pose_difference.h).
  [[nodiscard]] const std::vector<PoseEvidence>& ranked() const { return ranked_; }
  /// The best candidate that agrees with this pose; null if none does.
  [[nodiscard]] const PoseEvidence* nearest(const RigidTransform& a_from_b) const;
  /// Score difference between the best candidate and the next, its best rival.
  [[nodiscard]] double margin() const;

  /// The evidence for any pose, with colour as calibrated or corrected.
  [[nodiscard]] PoseEvidence examine(const RigidTransform& a_from_b) const;
  [[nodiscard]] PoseEvidence examine(const PairState& state) const;

  /// The matches on which two poses rest.
  struct RestingMatches {
    double one = 0, other = 0, common = 0;  // sums of their weights
  };
  [[nodiscard]] RestingMatches resting_matches(const RigidTransform& one,
                                               const RigidTransform& other) const;

  /// Whether both views have identical pictures.
  [[nodiscard]] bool same_pictures() const;

  [[nodiscard]] const SensorView& a() const { return *a_; }
  [[nodiscard]] const SensorView& b() const { return *b_; }
  [[nodiscard]] const std::vector<PointMatch>& matches() const { return matches_; }
  [[nodiscard]] const PairOptions& options() const { return options_; }

 private:
  void rank(const std::vector<PoseHypothesis>& hypotheses, ColorCalibration color);
  void keep_best(std::vector<PoseEvidence> found);
  [[nodiscard]] bool is_conclusive() const;
  [[nodiscard]] PoseEvidence settled(const PoseHypothesis& hypothesis,
                                     ColorCalibration color) const;

  const SensorView* a_;
  const SensorView* b_;
  PairOptions options_;
  std::vector<PointMatch> matches_;
  std::vector<PoseEvidence> ranked_;
};

}  // namespace roomcast::alignment
