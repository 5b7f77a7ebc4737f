// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/network_thread.h"

#include <boost/asio/steady_timer.hpp>
#include <gtest/gtest.h>

namespace roomcast::client {
namespace {

TEST(NetworkThread, runs_its_work_elsewhere_and_all_of_it) {
  NetworkThread network;
  std::thread::id ran_on;
  bool posted_by_last = false;
  boost::asio::post(network.io(), [&] { ran_on = std::this_thread::get_id(); });
  network.start();
  network.finish([&] { boost::asio::post(network.io(), [&] { posted_by_last = true; }); });
  EXPECT_NE(ran_on, std::thread::id());
  EXPECT_NE(ran_on, std::this_thread::get_id());
  EXPECT_TRUE(posted_by_last);
}

TEST(NetworkThread, the_last_task_can_end_the_others) {
  NetworkThread network;
  boost::asio::steady_timer never(network.io(), std::chrono::hours(1));
  bool ended = false;
  never.async_wait([&](boost::system::error_code error) {
    ended = error == boost::asio::error::operation_aborted;
  });
  network.start();
  network.finish([&] { never.cancel(); });
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace roomcast::client
