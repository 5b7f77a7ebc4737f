// SPDX-License-Identifier: Apache-2.0
// Inputs of `roomcast bench codec`: the frames of one sensor, with ground truth where it is known.
//   rig:DIR#s0, tum:DIR, a folder   a recording; depth truth from DIR/truth/<sensor>/%06d.png where
//                                   it is there, clean colour from
//                                   DIR/truth/<sensor>/color/%06d.jpg likewise. A rig without
//                                   #sensor: its first.
//   sim[:scene][#n]                 the simulator; depth truth, and noise-free colour
// Colour, including the true colour, is registered to the depth grid with the measured depth. The
// reference is therefore the clean colour of the surface point at the measured depth.
#pragma once

#include <memory>
#include <string>

#include "bench/codec/codec_under_test.h"

namespace roomcast::bench {

/// The reference for a frame's colour.
enum class ColorReference {
  kInput,     // the input itself
  kDenoised,  // the input after denoising (measure/temporal_mean.h)
  kClean,     // ground truth
};

/// Ground truth of one frame.
struct BenchTruth {
  DepthImage depth_mm;  // empty: unknown
  // The sensor's reading without random noise but with its systematic errors; empty: unknown. A
  // codec can remove noise, but not these errors, which are the same in every frame.
  DepthImage noise_free_mm;
  ColorImage color;  // see ColorReference; empty without colour
  // The median of what stands still; empty: unknown (back_and_forth_input.h).
  DepthImage still_mm;
};

class BenchInput {
 public:
  virtual ~BenchInput() = default;
  [[nodiscard]] virtual std::string name() const = 0;  // for the report
  [[nodiscard]] virtual double fps() const = 0;
  [[nodiscard]] virtual ColorReference color_reference() const = 0;
  /// False at the end. Errors of the source.
  virtual Result<bool> next(BenchFrame& frame, BenchTruth& truth) = 0;
};

struct BenchInputOptions {
  double sim_fps = 30;
  int sim_sensor_count = 3;
  std::uint64_t sim_seed = 1;
  double sim_speed = 1;  // speed factor of all motion; 0: static
  // Plays a recording forward and backward at this rate without an end; 0: once, at its own rate.
  double back_and_forth_fps = 0;
};

/// kInvalidArgument: INPUT has none of the forms above. Errors of the source.
[[nodiscard]] Result<std::unique_ptr<BenchInput>> open_bench_input(
    const std::string& input, const BenchInputOptions& options = {});

}  // namespace roomcast::bench
