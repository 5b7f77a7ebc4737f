// SPDX-License-Identifier: Apache-2.0
#include "bench/link/emulated_link.h"

#include <thread>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

namespace asio = boost::asio;
using namespace std::chrono_literals;
using Tcp = asio::ip::tcp;

TEST(EmulatedLink, tcp_across_it_takes_the_time_of_the_link) {
  const auto link = EmulatedLink::open({.mbit_per_s = 8, .round_trip = 40ms});
  if (!link) GTEST_SKIP() << link.error().message;
  asio::io_context io;
  std::optional<Tcp::acceptor> listener;
  (*link)->run(EmulatedLink::End::kNear,
               [&] { listener.emplace(io, Tcp::endpoint(Tcp::v4(), 0)); });
  Tcp::socket client(io);
  const auto address = asio::ip::make_address(EmulatedLink::address(EmulatedLink::End::kNear));
  const auto begin = std::chrono::steady_clock::now();
  (*link)->run(EmulatedLink::End::kFar, [&] {
    client.open(Tcp::v4());
    client.connect({address, listener->local_endpoint().port()});
  });
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 40ms) << "one round trip to connect";

  Tcp::socket server = listener->accept();
  std::vector<char> bytes(100'000);  // 100 ms on the wire
  std::jthread writer([&] { asio::write(server, asio::buffer(bytes)); });
  const auto sent = std::chrono::steady_clock::now();
  asio::read(client, asio::buffer(bytes));
  EXPECT_GE(std::chrono::steady_clock::now() - sent, 100ms);
  EXPECT_GE((*link)->carried_bytes(), bytes.size());
}

TEST(EmulatedLink, the_ends_do_not_see_this_machines_network) {
  const auto link = EmulatedLink::open({});
  if (!link) GTEST_SKIP() << link.error().message;
  asio::io_context io;
  Tcp::acceptor here(io, Tcp::endpoint(asio::ip::address_v4::loopback(), 0));
  boost::system::error_code error;
  (*link)->run(EmulatedLink::End::kFar, [&] {
    Tcp::socket client(io, Tcp::v4());
    client.connect(here.local_endpoint(), error);
  });
  EXPECT_EQ(error, asio::error::connection_refused);
}

}  // namespace
}  // namespace roomcast::bench
