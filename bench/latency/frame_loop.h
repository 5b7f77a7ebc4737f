// SPDX-License-Identifier: Apache-2.0
// FrameLoop: a few seconds of a sensor, captured beforehand, to be played forward and backward, so
// that the simulator's cost is not measured.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::bench {

/// Which of `count` frames comes at this place (0 or above) of the endless sequence: forward, then
/// backward, and so on.
[[nodiscard]] std::int64_t frame_at_place(std::int64_t place, std::int64_t count);

class FrameLoop {
 public:
  /// Captures up to `frame_count` frames. Errors: those of the source; kInvalidArgument: it has
  /// none.
  static Result<FrameLoop> capture(source::FrameSource& source, int frame_count);

  /// The frame at this place of the sequence.
  [[nodiscard]] const source::CapturedFrame& at(std::int64_t place) const;

 private:
  explicit FrameLoop(std::vector<source::CapturedFrame> frames) : frames_(std::move(frames)) {}

  std::vector<source::CapturedFrame> frames_;  // at least one
};

}  // namespace roomcast::bench
