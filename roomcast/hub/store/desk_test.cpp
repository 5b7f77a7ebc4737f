// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/desk.h"

#include <string>

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

TEST(Desk, answers_come_in_order_on_the_thread_that_asked) {
  boost::asio::io_context io;
  const auto keep_open = boost::asio::make_work_guard(io);
  Desk desk(*HubBook::open(std::nullopt), io);
  std::string order;
  std::thread::id worked_on;
  desk.ask([&](HubBook&) { return worked_on = std::this_thread::get_id(); },
           [&](std::thread::id) { order += "a"; });
  desk.ask([](HubBook& book) { return book.check("nonsense"); },
           [&](const Verdict<Claims>& verdict) {
             EXPECT_NE(refusal(verdict), nullptr);
             order += "b";
           });
  while (order.size() < 2) io.run_one_for(std::chrono::seconds(1));
  EXPECT_EQ(order, "ab");
  EXPECT_NE(worked_on, std::this_thread::get_id());
}

TEST(Desk, finishes_what_was_asked_before_it_goes) {
  boost::asio::io_context io;
  int done = 0;
  {
    Desk desk(*HubBook::open(std::nullopt), io);
    for (int i = 0; i < 10; ++i) desk.ask([&](HubBook&) { return ++done; }, [](int) {});
  }
  EXPECT_EQ(done, 10);
}

}  // namespace
}  // namespace roomcast::hub
