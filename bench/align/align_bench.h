// SPDX-License-Identifier: Apache-2.0
// Compares alignment methods on views with known poses: rate of correct poses, rate of accepted
// wrong poses, accuracy and CPU cost. Single-threaded.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/alignment/feature/sensor_view.h"

namespace roomcast::bench {

/// Two views of an input and their true relative pose.
struct AlignCase {
  std::size_t a = 0, b = 0;
  RigidTransform a_from_b;
  double overlap = 0;  // 0..1
};

struct AlignInput {
  std::string name;
  std::vector<std::shared_ptr<const alignment::SensorView>> views;
  std::vector<AlignCase> cases;
  bool whole_rig = false;  // the views belong to one rig and may be aligned together
};

/// An answer is correct when its rotation and translation errors are below these limits.
inline constexpr double kRightAngle_deg = 5, kRightDistance_m = 0.1;

struct AlignRow {
  std::string input, method, overlap;  // overlap: ">60 %", "30-60 %", "10-30 %", "<10 %"
  int pairs = 0, right = 0, accepted = 0, accepted_wrong = 0;
  double median_rotation_deg = 0, median_translation_mm = 0;  // of the correct answers
  double cpu_s_per_pair = 0;                                  // without making the views
};

using BenchProgress = std::function<void(std::string_view)>;

[[nodiscard]] std::vector<AlignRow> run_align_bench(const std::vector<AlignInput>& inputs,
                                                    const BenchProgress& progress);

void print_table(const std::vector<AlignRow>& rows, std::ostream& out);
void print_json(const std::vector<AlignRow>& rows, std::ostream& out);

}  // namespace roomcast::bench
