// SPDX-License-Identifier: Apache-2.0
// LatestMailbox: keeps one item; a newer item replaces one that was not taken. For live pictures,
// of which only the newest is useful. Thread-safe, any number of producers and consumers.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace roomcast {

template <class T>
class LatestMailbox {
 public:
  /// Never blocks. Returns the replaced item, so that its memory can be reused.
  std::optional<T> put(T item) {
    std::optional<T> dropped(std::move(item));
    {
      std::lock_guard lock(mutex_);
      std::swap(item_, dropped);
      if (dropped) ++dropped_count_;
    }
    ready_.notify_one();
    return dropped;
  }

  /// Waits for an item; nothing once stopped.
  std::optional<T> take(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    if (!ready_.wait(lock, stop, [this] { return item_.has_value(); })) return std::nullopt;
    return std::exchange(item_, std::nullopt);
  }

  std::optional<T> try_take() {
    std::lock_guard lock(mutex_);
    return std::exchange(item_, std::nullopt);
  }

  [[nodiscard]] std::uint64_t dropped_count() const {
    std::lock_guard lock(mutex_);
    return dropped_count_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable_any ready_;
  std::optional<T> item_;
  std::uint64_t dropped_count_ = 0;
};

}  // namespace roomcast
