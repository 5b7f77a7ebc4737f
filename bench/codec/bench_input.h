// SPDX-License-Identifier: Apache-2.0
// What `roomcast bench codec` measures on: the frames of one sensor with what is known of the
// truth.
//   rig:DIR#s0, tum:DIR, a folder   a recording; depth truth from DIR/truth/<sensor>/%06d.png where
//                                   it is there, clean colour from
//                                   DIR/truth/<sensor>/color/%06d.jpg likewise. A rig without
//                                   #sensor: its first.
//   sim[:scene][#n]                 the simulator; depth truth, and colour as a camera without
//   noise
//                                   would have seen it
// Colour is registered to the depth grid, the truth's too, with the measured depth: the reference
// is the clean colour of the surface point that the sensor believes in.
#pragma once

#include <memory>
#include <string>

#include "bench/codec/codec_under_test.h"

namespace roomcast::bench {

/// What a frame's colour is compared with.
enum class ColorReference {
  kInput,     // the input itself
  kDenoised,  // the input with its noise taken out (measure/temporal_mean.h)
  kClean,     // the truth
};

/// The truth of one frame.
struct BenchTruth {
  DepthImage depth_mm;  // empty: not known
  // What the sensor would have read without random noise, with its systematic errors; empty: not
  // known. A codec can take noise out, but not these errors, which are the same in every frame.
  DepthImage noise_free_mm;
  ColorImage color;  // ColorReference says what it is; empty without colour
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
  double sim_speed = 1;  // of all motion: 0 stands still
};

/// kInvalidArgument for an INPUT that is none of the above; else errors of the source.
[[nodiscard]] Result<std::unique_ptr<BenchInput>> open_bench_input(
    const std::string& input, const BenchInputOptions& options = {});

}  // namespace roomcast::bench
