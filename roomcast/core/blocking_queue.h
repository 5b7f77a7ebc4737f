// SPDX-License-Identifier: Apache-2.0
// BlockingQueue: first in, first out, never longer than its capacity; when full, the producer
// waits. For work where nothing may be lost (recording, conversion of files). Thread-safe, any
// number of each side.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

#include "roomcast/core/assert.h"

namespace roomcast {

template <class T>
class BlockingQueue {
 public:
  explicit BlockingQueue(std::size_t capacity) : capacity_(capacity) {
    ROOMCAST_ASSERT(capacity > 0);
  }

  /// Waits for room. False, and the item is not taken, once stopped or closed.
  bool push(T item, std::stop_token stop) {
    std::unique_lock lock(mutex_);
    const bool woken =
        changed_.wait(lock, stop, [this] { return closed_ || items_.size() < capacity_; });
    if (!woken || closed_) return false;
    items_.push_back(std::move(item));
    changed_.notify_all();
    return true;
  }

  /// Waits for an item; nothing once stopped, or once closed and empty.
  std::optional<T> pop(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    const bool woken = changed_.wait(lock, stop, [this] { return closed_ || !items_.empty(); });
    if (!woken || items_.empty()) return std::nullopt;
    std::optional<T> item(std::move(items_.front()));
    items_.pop_front();
    changed_.notify_all();
    return item;
  }

  /// No more items will come; what is queued can still be popped.
  void close() {
    std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<T> items_;
  const std::size_t capacity_;
  bool closed_ = false;
};

}  // namespace roomcast
