// SPDX-License-Identifier: Apache-2.0
// Compares the surface of a model with the true one, as a camera sees both. Errors are distances
// along the true normal. Pixels at outlines, where depth makes a step, are left out. Metres.
#pragma once

#include <cstddef>
#include <vector>

#include "bench/model/still_truth.h"
#include "roomcast/core/image.h"

namespace roomcast::bench {

struct SurfaceScore {
  std::vector<float> errors_m;  // where the model has a surface
  std::size_t seen = 0;         // pixels of still surfaces that a sensor saw: kMinReadings
  std::size_t covered = 0;      // of them: the model has the surface within 3 cm or 1 %
  std::size_t read_once = 0, covered_once = 0;  // the same with one reading
  std::size_t drawn = 0;     // pixels of still surfaces where the model has something
  std::size_t floating = 0;  // of them: the model has it more than 5 cm and 2 % in front
};

/// `model_m`: as mesh_depth_m. Returns a picture of it: surfaces that were seen and are covered
/// grey, the brighter the more exact; red where the model has nothing, blue where it has another
/// surface, yellow where something floats; black where nobody saw a still surface.
ColorImage add_score(const Image<float>& model_m, const StillTruth& truth, SurfaceScore& score);

struct ScoreFigures {
  double median_mm = 0, p90_mm = 0;
  double coverage = 0, coverage_once = 0;  // shares of what was seen, of what was read once
  double floating = 0;                     // share of what the model draws
  std::size_t pixels = 0;                  // seen
};
[[nodiscard]] ScoreFigures figures_of(SurfaceScore score);

}  // namespace roomcast::bench
