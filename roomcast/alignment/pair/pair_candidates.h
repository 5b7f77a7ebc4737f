// SPDX-License-Identifier: Apache-2.0
// Pose hypotheses for a pair of sensors, ranked, each with the evidence for and against it. The
// choice among them is made later, for the whole rig. Metres. Single-threaded.
#pragma once

#include <vector>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/feature_matches.h"
#include "roomcast/alignment/pair/free_space.h"
#include "roomcast/alignment/pair/match_support.h"
#include "roomcast/alignment/pair/photo_consistency.h"
#include "roomcast/alignment/pair/pose_refinement.h"
#include "roomcast/alignment/pair/spatial_vote.h"

namespace roomcast::alignment {

/// Evidence for and against a pose.
struct PoseEvidence {
  RigidTransform a_from_b;
  SensorCorrection correction_a, correction_b;  // assumed with the pose
  MatchSupport matches;
  FreeSpaceCheck space;
  SolidConflict solid;
  PhotoConsistency photo;
  double score = 0;  // total, in units of one unique match's weight; below 0: refuted
};

/// Whether the evidence suffices to accept the pose if no other fits as well.
[[nodiscard]] bool is_strong(const PoseEvidence& evidence);

/// Compares two versions of the same pose. Each kind of evidence is limited in the score, so that
/// none decides between poses alone. Of two nearly equal poses, the one with better colour
/// agreement is better.
[[nodiscard]] bool fits_better(const PoseEvidence& one, const PoseEvidence& other);

/// Pooled evidence of several pairs for poses that follow from one another.
struct PooledEvidence {
  double support = 0, score = 0, textured = 0, correlated = 0;
  int cells = 0;

  void add(const PoseEvidence& evidence);
};

/// Whether pooled evidence suffices for poses of which none is strong alone.
[[nodiscard]] bool is_strong(const PooledEvidence& evidence);

/// Score margin by which an answer must exceed its best rival.
inline constexpr double kMinMargin = 6;

/// Score cost of each pose that an answer adds; the pose's evidence must exceed it.
inline constexpr double kPoseCost = 6;

class PairCandidates {
 public:
  /// The views must outlive this object. There are no candidates where both views have identical
  /// pictures, because one is a copy.
  PairCandidates(const SensorView& a, const SensorView& b, std::vector<PointMatch> matches);

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

  /// Whether both views have identical pictures.
  [[nodiscard]] bool same_pictures() const;

  [[nodiscard]] const SensorView& a() const { return *a_; }
  [[nodiscard]] const SensorView& b() const { return *b_; }
  [[nodiscard]] const std::vector<PointMatch>& matches() const { return matches_; }

 private:
  void rank(const std::vector<PoseHypothesis>& hypotheses, ColorCalibration color);
  void keep_best(std::vector<PoseEvidence> found);
  [[nodiscard]] bool is_conclusive() const;
  [[nodiscard]] PoseEvidence settled(const PoseHypothesis& hypothesis,
                                     ColorCalibration color) const;

  const SensorView* a_;
  const SensorView* b_;
  std::vector<PointMatch> matches_;
  std::vector<PoseEvidence> ranked_;
};

}  // namespace roomcast::alignment
