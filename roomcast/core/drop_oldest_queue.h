// SPDX-License-Identifier: Apache-2.0
// DropOldestQueue: a FIFO of bounded capacity; a push into a full queue drops the oldest item. For
// streams in which a gap is better than a delay. Thread-safe, any number of producers and
// consumers.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

#include "roomcast/core/assert.h"

namespace roomcast {

template <class T>
class DropOldestQueue {
 public:
  explicit DropOldestQueue(std::size_t capacity) : capacity_(capacity) {
    ROOMCAST_ASSERT(capacity > 0);
  }

  /// Never blocks. Returns the dropped item, if any.
  std::optional<T> push(T item) {
    std::optional<T> dropped;
    {
      std::lock_guard lock(mutex_);
      if (items_.size() == capacity_) {
        dropped = std::move(items_.front());
        items_.pop_front();
        ++dropped_count_;
      }
      items_.push_back(std::move(item));
    }
    ready_.notify_one();
    return dropped;
  }

  /// Waits for an item; nothing once stopped.
  std::optional<T> pop(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    if (!ready_.wait(lock, stop, [this] { return !items_.empty(); })) return std::nullopt;
    return take_front();
  }

  std::optional<T> try_pop() {
    std::lock_guard lock(mutex_);
    if (items_.empty()) return std::nullopt;
    return take_front();
  }

  [[nodiscard]] std::uint64_t dropped_count() const {
    std::lock_guard lock(mutex_);
    return dropped_count_;
  }

 private:
  std::optional<T> take_front() {
    std::optional<T> item(std::move(items_.front()));
    items_.pop_front();
    return item;
  }

  mutable std::mutex mutex_;
  std::condition_variable_any ready_;
  std::deque<T> items_;
  const std::size_t capacity_;
  std::uint64_t dropped_count_ = 0;
};

}  // namespace roomcast
