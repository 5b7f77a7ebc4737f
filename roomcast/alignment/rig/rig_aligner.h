// SPDX-License-Identifier: Apache-2.0
// RigAligner: registers the sensors of a room in one world frame, without markers. Views can be
// added while the room runs; only new pairs are compared. A doubtful sensor is refused rather than
// placed wrongly: it is placed only if no other answer scores nearly as well. Deterministic: the
// same views in the same order give the same bits. Metres. Single-threaded.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/feature_matches.h"
#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/alignment/rig/placed_rig.h"
#include "roomcast/alignment/rig/pose_selection.h"

namespace roomcast::alignment {

/// Called before each step with its description and the progress (0..1).
using AlignProgress = std::function<void(std::string_view step, double done)>;

/// Whether a sensor's readings may be multiplied by a factor. Poses then hold only for readings
/// with that factor.
enum class DepthScaling { kAsCalibrated, kEstimated };

class RigAligner {
 public:
  /// `options` have passed check(). Views have options of their own.
  explicit RigAligner(const RigOptions& options = {},
                      DepthScaling scaling = DepthScaling::kAsCalibrated)
      : options_(options), scaling_(scaling) {}

  /// For the next solve().
  void set_scaling(DepthScaling scaling) { scaling_ = scaling; }

  /// Replaces an earlier sensor of the same name.
  void add(std::shared_ptr<const SensorView> view);
  void remove(const std::string& name);

  /// Compares new pairs and places all sensors. `progress` may be empty.
  [[nodiscard]] AlignmentReport solve(const AlignProgress& progress = {});

  /// The candidates of two sensors as of the last solve(), in either order of names. Null if they
  /// are not known.
  [[nodiscard]] const PairCandidates* pair(const std::string& one, const std::string& other) const;

 private:
  using Names = std::pair<std::string, std::string>;
  struct Pair {
    ViewComparison comparison;
    std::unique_ptr<PairCandidates> candidates;  // set once all pairs are compared
    bool has_affine_matches = false;
  };

  void compare_new_pairs(const AlignProgress& progress);
  void find_new_candidates(const AlignProgress& progress);
  /// Estimates the sensors' depth scales and remakes the views of those that have one. Returns
  /// whether there are any.
  [[nodiscard]] bool rescale_views();
  void report_scales(AlignmentReport& report) const;
  [[nodiscard]] bool add_affine_matches_to_refused(const AlignmentReport& report,
                                                   const AlignProgress& progress);
  [[nodiscard]] const FeatureSet& affine_features_of(const SensorView& view);
  [[nodiscard]] AlignmentReport placed() const;
  [[nodiscard]] std::vector<DescriptorAmbiguity> look_alikes_in_rig() const;
  [[nodiscard]] std::vector<RigPair> pairs() const;

  RigOptions options_;
  DepthScaling scaling_;
  std::vector<std::shared_ptr<const SensorView>> views_;
  std::map<Names, Pair> pairs_;
  std::map<std::string, DepthScale> depth_scales_;     // by sensor, with which views were made
  std::map<std::string, FeatureSet> affine_features_;  // by sensor, only where needed
};

}  // namespace roomcast::alignment
