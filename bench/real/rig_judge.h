// SPDX-License-Identifier: Apache-2.0
// Independent judges of a rig's poses, which alignment is never given.
// - ball.json in the rig's folder: where each sensor saw the centre of one ball, frame by frame.
// Two
//   sensors that saw it at the same instant must put it at the same place.
// - the poses of rig.json, where it has them.
// - loops: the relative poses of three pairs of sensors, one after the other, lead back to the
//   start. Pairs are estimated independently of each other, so their errors show in the loop.
// Millimetres and degrees. Pure but for reading files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::bench {

/// The ball as two sensors see it.
struct BallGap {
  std::string a, b;
  std::size_t instants = 0;
  double median_mm = 0;    // between its two places
  double expected_mm = 0;  // by the expected errors of both sensors
};

struct PoseGap {
  std::string sensor;
  double from_known_mm = 0, from_known_deg = 0;  // relative to the first placed sensor, 2.5 m ahead
};

struct Loop {
  std::string a, b, c;
  double closure_mm = 0, closure_deg = 0;  // 2.5 m ahead of a
};

struct RigJudgement {
  std::vector<BallGap> ball;   // of pairs of placed sensors that saw it together
  std::vector<PoseGap> known;  // of placed sensors but the first
  std::vector<Loop> loops;
};

/// kMalformed, naming the field, for a ball.json of another form; no file is no error.
[[nodiscard]] Result<RigJudgement> judge_rig(const std::filesystem::path& folder,
                                             const recording::RigDescription& rig,
                                             const alignment::AlignmentReport& alignment);

}  // namespace roomcast::bench
