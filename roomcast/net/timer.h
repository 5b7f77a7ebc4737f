// SPDX-License-Identifier: Apache-2.0
// Timer: calls an action later, once or again and again, and can be stopped for certain.
// boost::asio's own timers cannot: cancel() does not reach a handler that is queued already, which
// then runs as if nothing had happened and may set the timer again, for ever, or use an owner that
// is gone. Here an action is called only while the order that gave it still holds.
// Threading: lives on one io_context of one thread, and is used and destroyed there, or after that
// thread has ended.
#pragma once

#include <chrono>
#include <memory>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

namespace roomcast::net {

class Timer {
 public:
  using Duration = std::chrono::steady_clock::duration;

  explicit Timer(boost::asio::io_context& io) : timer_(io) {}

  /// Calls `action` after `delay`. Replaces the order before.
  template <class Action>
  void once(Duration delay, Action action) {
    if (!renew_order()) return;
    timer_.expires_after(delay);
    timer_.async_wait([order = std::weak_ptr(order_),
                       action = std::move(action)](boost::system::error_code error) mutable {
      if (!error && !order.expired()) action();
    });
  }

  /// Calls `action` every `interval`, counted from the end of the call before. Replaces the order
  /// before. `action` may cancel, stop or destroy the timer.
  template <class Action>
  void repeat(Duration interval, Action action) {
    if (renew_order()) wait(interval, std::move(action));
  }

  /// From here on no action ordered before is called, not even one that is due already.
  void cancel() {
    order_.reset();
    timer_.cancel();
  }

  /// cancel() for good: later orders are ignored.
  void stop() {
    is_stopped_ = true;
    cancel();
  }

 private:
  struct Order {};

  [[nodiscard]] bool renew_order() {
    order_ = is_stopped_ ? nullptr : std::make_shared<Order>();
    return !is_stopped_;
  }

  template <class Action>
  void wait(Duration interval, Action action) {
    timer_.expires_after(interval);
    timer_.async_wait([this, interval, order = std::weak_ptr(order_),
                       action = std::move(action)](boost::system::error_code error) mutable {
      if (error || order.expired()) return;
      action();
      if (!order.expired()) wait(interval, std::move(action));
    });
  }

  boost::asio::steady_timer timer_;
  std::shared_ptr<Order> order_;  // null: nothing is to be called
  bool is_stopped_ = false;
};

}  // namespace roomcast::net
