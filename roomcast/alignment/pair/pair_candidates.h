// SPDX-License-Identifier: Apache-2.0
// All that two sensors say about how they stand to each other: several pose hypotheses, each with
// the evidence for and against it, ranked. Which of them is true is decided later, by the whole
// rig. Metres. Single-threaded.
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

/// What speaks for a pose and what against it.
struct PoseEvidence {
  RigidTransform a_from_b;
  SensorCorrection correction_a, correction_b;  // that the pose goes with
  MatchSupport matches;
  FreeSpaceCheck space;
  SolidConflict solid;
  PhotoConsistency photo;
  double score =
      0;  // all of it in one number: about the weight of unique matches; below 0: refuted
};

/// Enough for a pose to be believed if no other fits as well.
[[nodiscard]] bool is_strong(const PoseEvidence& evidence);

/// Of two versions of the same pose. No one kind of evidence may decide between poses, so each has
/// a limit in the score; but of two that say nearly the same the one is better whose colours agree
/// more.
[[nodiscard]] bool fits_better(const PoseEvidence& one, const PoseEvidence& other);

/// What several pairs say for poses that follow from one another, put together.
struct PooledEvidence {
  double support = 0, score = 0, textured = 0, correlated = 0;
  int cells = 0;

  void add(const PoseEvidence& evidence);
};

/// Enough for poses of which no single one could be believed.
[[nodiscard]] bool is_strong(const PooledEvidence& evidence);

/// By this much an answer must be ahead of its best rival.
inline constexpr double kMinMargin = 6;

/// What an answer pays for every pose that it takes on trust; each must explain more.
inline constexpr double kPoseCost = 6;

class PairCandidates {
 public:
  /// The views must outlive this. None where both gave the same pictures: one is a copy.
  PairCandidates(const SensorView& a, const SensorView& b, std::vector<PointMatch> matches);

  /// Judges all anew with more matches, found by a closer look (feature/affine_features.h).
  void add_affine_matches(const std::vector<PointMatch>& more);

  /// Whether one of them, at least, might be the answer.
  [[nodiscard]] bool has_plausible() const;

  /// Best first; no two of them say the same.
  [[nodiscard]] const std::vector<PoseEvidence>& ranked() const { return ranked_; }
  /// The best that says the same as this pose; null where none does.
  [[nodiscard]] const PoseEvidence* nearest(const RigidTransform& a_from_b) const;
  /// How far the best is ahead of the best that says something else.
  [[nodiscard]] double margin() const;

  /// The evidence for any pose, with colour as calibrated or corrected.
  [[nodiscard]] PoseEvidence examine(const RigidTransform& a_from_b) const;
  [[nodiscard]] PoseEvidence examine(const PairState& state) const;

  /// Whether both gave the very same pictures.
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
