// SPDX-License-Identifier: Apache-2.0
// `roomcast bench redundancy`: how much of what a rig's sensors send shows surfaces that another
// sensor of the rig shows better, and how many bytes it would save not to send that. Blocks of 8 x
// 8 pixels that others have shown better for some frames are, in two further encodings, left as
// they were ("frozen"), or sent without depth and colour ("left out"). Frozen blocks still go into
// key frames; left out ones cost their edges.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "bench/redundancy/better_shown.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::bench {

struct RedundancyOptions {
  BetterShownOptions better;
  std::size_t frames = 0;     // of each sensor, played forward and backward; 0: as recorded
  double key_interval_s = 4;  // of the streams
};

struct SensorRedundancy {
  std::string name;
  double better_share = 0;                                 // of the pixels with depth
  double better_moving_share = 0;                          // of those that moved
  double bytes = 0, frozen_bytes = 0, left_out_bytes = 0;  // of all frames
};

struct RedundancyReport {
  std::string rig;
  double fps = 0;
  std::size_t frames = 0;
  std::vector<SensorRedundancy> sensors;
};

/// `rig` with poses, of `folder`. kInvalidArgument: it has fewer than two sensors, or a sensor
/// without a pose. Errors of reading and encoding.
[[nodiscard]] Result<RedundancyReport> run_redundancy_bench(
    const std::filesystem::path& folder, const recording::RigDescription& rig,
    const RedundancyOptions& options, const std::function<void(const std::string&)>& progress);

void print_table(const RedundancyReport& report, std::ostream& out);
void print_json(const std::vector<RedundancyReport>& reports, std::ostream& out);

}  // namespace roomcast::bench
