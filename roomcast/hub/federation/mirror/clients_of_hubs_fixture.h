// SPDX-License-Identifier: Apache-2.0
// For tests of hubs that show each other's sensors: clients of several running hubs on one loop.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <gtest/gtest.h>

#include "roomcast/hub/server/hub_server_fixture.h"
#include "roomcast/hub/server/running_hub.h"

namespace roomcast::hub::federation {

class ClientsOfHubs : public testing::Test {
 protected:
  using Client = std::shared_ptr<hub::RawClient>;

  Client join(const hub::RunningHub& hub, const wire::pb::Control& message) {
    auto client = std::make_shared<hub::RawClient>(std::deque{hub::framed_control(message)});
    net::connect(io, {.host = "127.0.0.1", .port = hub.port()}, {}, [=, this](auto socket) {
      ASSERT_TRUE(socket.ok());
      (*socket)->start(client);
      sockets.push_back(*socket);
    });
    run_until([&] { return !client->received.empty(); });
    return client;
  }

  void run_until(const std::function<bool()>& done) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (!done() && io.run_one_until(give_up) > 0) {
    }
    ASSERT_TRUE(done()) << "nothing happened in 5 s";
  }

  /// Sends key frames until `viewer` has received one.
  void send_until_seen(const Client& sensor, const Client& viewer) {
    const auto seen = viewer->frames.size();
    boost::asio::steady_timer pace(io);
    std::function<void()> send = [&] {
      sensor->send(hub::key_frame(seq++));
      sockets.front()->wake();
      pace.expires_after(std::chrono::milliseconds(10));
      pace.async_wait([&](boost::system::error_code error) {
        if (!error) send();
      });
    };
    send();
    run_until([&] { return viewer->frames.size() > seen; });
    pace.cancel();
    io.poll();
  }

  /// The metrics of a hub, which runs on threads of its own.
  static std::string metrics_of(const hub::RunningHub& hub) {
    using boost::asio::ip::tcp;
    boost::asio::io_context asking;
    tcp::socket socket(asking);
    socket.connect({boost::asio::ip::make_address("127.0.0.1"), hub.port()});
    const std::string request =
        "GET /metrics HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n";
    boost::asio::write(socket, boost::asio::buffer(request));
    std::string answer;
    boost::system::error_code end;
    boost::asio::read(socket, boost::asio::dynamic_buffer(answer), end);
    return answer;
  }

  /// Closes all clients; otherwise the hubs would wait for the answers to their close frames.
  void disconnect_all() {
    for (const auto& socket : sockets) socket->close(net::close_code::kNormal, "left");
    io.run_for(std::chrono::milliseconds(100));
  }

  boost::asio::io_context io;
  std::vector<std::shared_ptr<net::WebSocketConnection>> sockets;
  std::uint32_t seq = 0;
};

}  // namespace roomcast::hub::federation
