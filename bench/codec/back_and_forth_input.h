// SPDX-License-Identifier: Apache-2.0
// A short recording as a longer input: its frames forward, backward, forward and so on, at a given
// rate. If the sensor is fixed, what stands still in the recording has a reference: its median over
// all frames (measure/still_surfaces.h).
#pragma once

#include <memory>

#include "bench/codec/bench_input.h"

namespace roomcast::bench {

/// Longer recordings are played up to this frame; all of them are kept in memory.
inline constexpr int kMaxFramesBackAndForth = 64;

/// Reads the frames of `recording` at once. Its next() never returns false. Errors of the
/// recording; kInvalidArgument if it has no frame or frames of several sizes.
[[nodiscard]] Result<std::unique_ptr<BenchInput>> play_back_and_forth(
    std::unique_ptr<BenchInput> recording, double fps);

}  // namespace roomcast::bench
