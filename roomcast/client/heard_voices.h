// SPDX-License-Identifier: Apache-2.0
// HeardVoices: the audio packets that a viewer has received and its program has not taken yet; the
// oldest are dropped. Thread-safe.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"

namespace roomcast::client {

/// 20 ms of somebody's voice.
struct HeardPacket {
  ViewerId speaker{};
  std::uint32_t seq = 0;    // counts the speaker's packets
  bool ends = false;        // the speaker pauses after it
  RoomTime capture_time{};  // of the first sample
  std::vector<std::uint8_t> opus;
};

class HeardVoices {
 public:
  static constexpr std::size_t kMaxWaiting = 400;  // 1 s of eight people

  void push(HeardPacket packet) {
    {
      const std::lock_guard lock(mutex_);
      if (ended_) return;
      if (packets_.size() == kMaxWaiting) packets_.pop_front();
      packets_.push_back(std::move(packet));
    }
    came_.notify_one();
  }
  /// Nothing at the timeout, or once nothing will come any more.
  std::optional<HeardPacket> next(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    came_.wait_for(lock, timeout, [this] { return !packets_.empty() || ended_; });
    if (packets_.empty()) return std::nullopt;
    auto packet = std::move(packets_.front());
    packets_.pop_front();
    return packet;
  }
  void end() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    came_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable came_;
  std::deque<HeardPacket> packets_;
  bool ended_ = false;
};

}  // namespace roomcast::client
