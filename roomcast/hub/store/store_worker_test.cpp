// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/store_worker.h"

#include <string>

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

TEST(StoreWorker, answers_in_order_on_the_asking_thread) {
  boost::asio::io_context io;
  const auto keep_open = boost::asio::make_work_guard(io);
  StoreWorker store_worker(*HubStore::open(std::nullopt), io);
  std::string order;
  std::thread::id worked_on;
  store_worker.ask([&](HubStore&) { return worked_on = std::this_thread::get_id(); },
                   [&](std::thread::id) { order += "a"; });
  store_worker.ask([](HubStore& store) { return store.check("nonsense"); },
                   [&](const Verdict<Claims>& verdict) {
                     EXPECT_NE(refusal(verdict), nullptr);
                     order += "b";
                   });
  while (order.size() < 2) io.run_one_for(std::chrono::seconds(1));
  EXPECT_EQ(order, "ab");
  EXPECT_NE(worked_on, std::this_thread::get_id());
}

TEST(StoreWorker, finishes_pending_requests_before_it_ends) {
  boost::asio::io_context io;
  int done = 0;
  {
    StoreWorker store_worker(*HubStore::open(std::nullopt), io);
    for (int i = 0; i < 10; ++i) store_worker.ask([&](HubStore&) { return ++done; }, [](int) {});
  }
  EXPECT_EQ(done, 10);
}

}  // namespace
}  // namespace roomcast::hub
