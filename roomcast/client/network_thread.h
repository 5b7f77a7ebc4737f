// SPDX-License-Identifier: Apache-2.0
// NetworkThread: an event loop and the thread that runs it, from start() to finish(). Threading:
// start() and finish() from the owner's thread; work posted to io() runs on the loop's thread.
#pragma once

#include <future>
#include <thread>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>

namespace roomcast::client {

class NetworkThread {
 public:
  [[nodiscard]] boost::asio::io_context& io() { return io_; }

  void start() {
    thread_ = std::jthread([this] { io_.run(); });
  }

  /// Runs `action` on the loop and waits for it. Not to be called from the loop's thread.
  template <class Action>
  void run(Action action) {
    std::promise<void> done;
    boost::asio::post(io_, [&] {
      action();
      done.set_value();
    });
    done.get_future().get();
  }

  /// Runs `last` on the loop and waits until no work is left. `last` has to end all work that would
  /// otherwise not end.
  template <class Last>
  void finish(Last last) {
    boost::asio::post(io_, [this, last = std::move(last)]() mutable {
      last();
      work_.reset();
    });
    thread_.join();
  }

 private:
  boost::asio::io_context io_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_{
      io_.get_executor()};
  std::jthread thread_;
};

}  // namespace roomcast::client
