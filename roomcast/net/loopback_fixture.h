// SPDX-License-Identifier: Apache-2.0
// For the tests of net/: real sockets on 127.0.0.1, one io_context, and bounded waits only.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <boost/asio/buffer.hpp>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <gtest/gtest.h>

#include "roomcast/net/websocket_connection.h"

namespace roomcast::net {

/// A handler that records its calls and sends the messages queued in `to_send`.
class RecordingHandler : public ConnectionHandler {
 public:
  void on_message(MessageBuffer message) override {
    EXPECT_FALSE(closed) << "a message after on_closed()";
    messages.emplace_back(message.payload().begin(), message.payload().end());
    if (when_message) when_message();
  }
  void on_read_done() override {
    EXPECT_FALSE(closed) << "asked after on_closed()";
    messages_when_read_done.push_back(messages.size());
  }
  FramedMessagePtr next_message() override {
    EXPECT_FALSE(closed) << "asked after on_closed()";
    ++times_asked;
    if (to_send.empty()) return nullptr;
    auto message = std::move(to_send.front());
    to_send.pop_front();
    ++times_given;
    return message;
  }
  void on_closed(const CloseReason& reason) override {
    EXPECT_FALSE(closed) << "closed twice";
    closed = reason;
  }

  std::vector<std::vector<std::uint8_t>> messages;
  std::function<void()> when_message;
  std::vector<std::size_t> messages_when_read_done;
  std::deque<FramedMessagePtr> to_send;
  int times_asked = 0;
  int times_given = 0;
  std::optional<CloseReason> closed;
};

inline FramedMessagePtr message_of(std::string_view text) {
  return frame_message(
      MessageBuffer(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size())));
}

class LoopbackTest : public ::testing::Test {
 protected:
  using Tcp = boost::asio::ip::tcp;

  /// Runs the loop until `done`; fails the test after 10 s.
  [[nodiscard]] ::testing::AssertionResult run_until(const std::function<bool()>& done) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!done()) {
      if (std::chrono::steady_clock::now() > deadline) {
        return ::testing::AssertionFailure() << "did not happen within 10 s";
      }
      if (io_.stopped()) io_.restart();
      io_.run_one_for(std::chrono::milliseconds(50));
    }
    return ::testing::AssertionSuccess();
  }

  /// Runs the loop for `duration`, calling `turn` in between; returns the longest time between two
  /// iterations, caused by load on the machine.
  std::chrono::nanoseconds run_for(std::chrono::nanoseconds duration,
                                   const std::function<void()>& turn = {}) {
    std::chrono::nanoseconds longest{0};
    const auto begin = std::chrono::steady_clock::now();
    for (auto before = begin; before < begin + duration;) {
      if (turn) turn();
      if (io_.stopped()) io_.restart();
      io_.run_one_for(std::chrono::milliseconds(1));
      const auto now = std::chrono::steady_clock::now();
      longest = std::max<std::chrono::nanoseconds>(longest, now - before);
      before = now;
    }
    return longest;
  }

  /// Runs ready handlers only, without waiting.
  void run_ready() {
    io_.restart();
    io_.poll();
  }

  struct SocketPair {
    Tcp::socket ours;
    Tcp::socket theirs;
  };
  SocketPair connected_sockets() {
    Tcp::acceptor acceptor(io_, Tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0));
    Tcp::socket theirs(io_);
    theirs.connect(acceptor.local_endpoint());
    return {acceptor.accept(), std::move(theirs)};
  }

  /// A plain blocking connection to a server under test.
  Tcp::socket raw_connection(std::uint16_t port) {
    Tcp::socket socket(io_);
    socket.connect({boost::asio::ip::address_v4::loopback(), port});
    return socket;
  }

  static void send(Tcp::socket& socket, std::string_view bytes) {
    boost::asio::write(socket, boost::asio::buffer(bytes));
  }

  /// Receives until the other side closes or `enough` returns true. The loop runs meanwhile.
  std::string receive(Tcp::socket& socket,
                      const std::function<bool(const std::string&)>& enough = {}) {
    std::string received;
    bool ended = false;
    std::vector<char> buffer(64 * 1024);
    std::function<void()> read = [&] {
      socket.async_read_some(boost::asio::buffer(buffer),
                             [&](boost::system::error_code error, std::size_t size) {
                               received.append(buffer.data(), size);
                               ended = error || (enough && enough(received));
                               if (!ended) read();
                             });
    };
    read();
    EXPECT_TRUE(run_until([&] { return ended; })) << "received so far: " << received.substr(0, 500);
    return received;
  }

  boost::asio::io_context io_{1};
};

}  // namespace roomcast::net
