// SPDX-License-Identifier: Apache-2.0
// PlayedSound: what the loudspeaker was handed, for the echo canceller: 20 ms each. The two run at
// nearly the same pace; what one is ahead of the other is left out or silence. Thread-safe.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <mutex>

#include "roomcast/sound/loudspeaker.h"

namespace roomcast::viewer {

class PlayedSound {
 public:
  static constexpr std::size_t kMaxWaiting = 3;  // blocks

  using Block = std::array<float, voice::kPacketSamples>;

  /// The mean of left and right.
  void push(const sound::StereoBlock& played) {
    Block mean{};
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = (played[2 * i] + played[2 * i + 1]) / 2;
    const std::lock_guard lock(mutex_);
    if (waiting_.size() == kMaxWaiting) waiting_.pop_front();
    waiting_.push_back(mean);
  }
  /// The oldest that was not taken yet; silence if there is none.
  [[nodiscard]] Block take() {
    const std::lock_guard lock(mutex_);
    if (waiting_.empty()) return {};
    const Block oldest = waiting_.front();
    waiting_.pop_front();
    return oldest;
  }

 private:
  std::mutex mutex_;
  std::deque<Block> waiting_;
};

}  // namespace roomcast::viewer
