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

std::int64_t frame_at_place(std::int64_t place, std::int64_t count) {
  const std::int64_t last = count - 1;
  const std::int64_t phase = last > 0 ? place % (2 * last) : 0;
  return std::min(phase, 2 * last - phase);
}

const source::CapturedFrame& FrameLoop::at(std::int64_t place) const {
  const auto count = static_cast<std::int64_t>(frames_.size());
  return frames_[static_cast<std::size_t>(frame_at_place(place, count))];
}

}  // namespace roomcast::bench
