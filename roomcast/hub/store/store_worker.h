// SPDX-License-Identifier: Apache-2.0
// StoreWorker: the one thread that uses a hub's store, so that no thread that serves frames waits
// for the disk or for a signature. Requests run in the order of the calls. Threading: ask() and the
// answers on the thread that runs `answers`.
#pragma once

#include <memory>
#include <thread>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>

#include "roomcast/hub/store/hub_store.h"

namespace roomcast::hub {

class StoreWorker {
 public:
  StoreWorker(std::unique_ptr<HubStore> store, boost::asio::io_context& answers)
      : store_(std::move(store)), answers_(answers), thread_([this] { io_.run(); }) {}

  /// Finishes the pending requests; answers that have not been delivered by then are lost.
  ~StoreWorker() { keep_open_.reset(); }
  StoreWorker(const StoreWorker&) = delete;
  StoreWorker& operator=(const StoreWorker&) = delete;

  /// Runs `work(store)` on the worker, then `then(result)` on the thread that runs `answers`.
  template <class Work, class Then>
  void ask(Work work, Then then) {
    boost::asio::post(io_, [this, work = std::move(work), then = std::move(then)]() mutable {
      boost::asio::post(answers_, [then = std::move(then), answer = work(*store_)]() mutable {
        then(std::move(answer));
      });
    });
  }

 private:
  std::unique_ptr<HubStore> store_;
  boost::asio::io_context& answers_;
  boost::asio::io_context io_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> keep_open_ =
      boost::asio::make_work_guard(io_);
  std::jthread thread_;  // last: uses all of the above
};

}  // namespace roomcast::hub
