// SPDX-License-Identifier: Apache-2.0
#include "bench/latency/frame_loop.h"

#include <algorithm>

namespace roomcast::bench {

Result<FrameLoop> FrameLoop::capture(source::FrameSource& source, int frame_count) {
  std::vector<source::CapturedFrame> frames;
  for (int i = 0; i < frame_count; ++i) {
    source::CapturedFrame frame;
    const auto more = source.next(frame, {});
    if (!more) return more.error();
    if (!*more) break;
    frames.push_back(std::move(frame));
  }
  if (frames.empty()) return invalid_argument("this source has no frame");
  return FrameLoop(std::move(frames));
}

const source::CapturedFrame& FrameLoop::at(std::int64_t place) const {
  const auto last = static_cast<std::int64_t>(frames_.size()) - 1;
  const std::int64_t phase = last > 0 ? place % (2 * last) : 0;
  return frames_[static_cast<std::size_t>(std::min(phase, 2 * last - phase))];
}

}  // namespace roomcast::bench
