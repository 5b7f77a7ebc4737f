// SPDX-License-Identifier: Apache-2.0
// BlockingQueue: a FIFO of bounded capacity; a producer waits while it is full. For work in which
// no item may be lost (recording, file conversion). Thread-safe, any number of producers and
// consumers.
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

  /// Waits for free capacity. False, and the item is discarded, once stopped or closed.
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

  /// Accepts no more items; items already queued can still be popped.
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
