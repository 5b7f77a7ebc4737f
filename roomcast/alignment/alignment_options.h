// SPDX-License-Identifier: Apache-2.0
// All numbers of alignment that can be tuned, stage by stage, with their usual values. Each stage
// declares its own struct beside its code, with units, origins and legal ranges, and is given it by
// the caller. `roomcast align --json --verbose` prints the tree. Plain data.
//
// Of the origins, "the development rooms" are the recordings `redkitchen_moving` and `house3` and
// simulated rooms: values were chosen there, and judged on others (docs/benchmarks/alignment.md,
// live-alignment.md). "The prototype's" were measured on `redkitchen_moving` and simulated rooms
// before this code was written. "By hand" are values that were never compared with others.
#pragma once

#include "roomcast/alignment/bundle/bundle_capture.h"
#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/homography/homography_pose.h"
#include "roomcast/alignment/motion/pose_change_detector.h"
#include "roomcast/alignment/person/head_detector.h"
#include "roomcast/alignment/person/trajectory_match.h"
#include "roomcast/alignment/prior/nudged_pose.h"
#include "roomcast/alignment/prior/refined_placement.h"
#include "roomcast/alignment/prior/stored_pose_check.h"
#include "roomcast/alignment/rig/placed_rig.h"
#include "roomcast/core/option_fields.h"

namespace roomcast::alignment {

struct AlignmentOptions {
  // From frames to poses, as `roomcast align` does it.
  BundleCaptureOptions bundle;
  SensorViewOptions view;
  RigOptions rig;  // and its pairs
  HomographyOptions homography;

  // In a running room, besides.
  NudgeOptions nudge;
  StoredPoseOptions stored_pose;
  RefinedPlacementOptions refined_placement;
  HeadDetectorOptions heads;
  TrajectoryMatchOptions trajectories;
  PoseChangeOptions pose_change;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("bundle", bundle);
    visit("view", view);
    visit("rig", rig);
    visit("homography", homography);
    visit("nudge", nudge);
    visit("stored_pose", stored_pose);
    visit("refined_placement", refined_placement);
    visit("heads", heads);
    visit("trajectories", trajectories);
    visit("pose_change", pose_change);
  }
  /// kInvalidArgument names the first field that is outside its range, and the range.
  [[nodiscard]] Status check() const { return check_fields("AlignmentOptions", *this); }
};

}  // namespace roomcast::alignment
