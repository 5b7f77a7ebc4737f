// SPDX-License-Identifier: Apache-2.0
// For the tests of WebSocketConnection: two connections to each other, or one connection and a peer
// that the test scripts byte by byte.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "roomcast/net/loopback_fixture.h"
#include "roomcast/net/websocket_connection.h"
#include "roomcast/net/websocket_reader.h"

namespace roomcast::net {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::size_t kTwoMiB = std::size_t{2} << 20;

inline Bytes bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

inline Bytes pattern(std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * 31 + (i >> 9));
  return bytes;
}

class WebSocketPairTest : public LoopbackTest {
 protected:
  struct End {
    std::shared_ptr<WebSocketConnection> connection;
    std::shared_ptr<RecordingHandler> handler = std::make_shared<RecordingHandler>();

    void send(FramedMessagePtr message) {
      handler->to_send.push_back(std::move(message));
      connection->wake();
    }
    [[nodiscard]] bool closed() const { return handler->closed.has_value(); }
  };

  static ConnectionOptions options(WebSocketRole role, ConnectionTimings timings = {}) {
    ConnectionOptions options;
    options.role = role;
    options.max_message_bytes = kTwoMiB;
    options.timings = timings;
    return options;
  }

  End open(Tcp::socket socket, ConnectionOptions options,
           std::span<const std::uint8_t> received = {}) {
    End end;
    end.connection = std::make_shared<WebSocketConnection>(Stream(std::move(socket)),
                                                           std::move(options), received);
    end.connection->start(end.handler);
    return end;
  }

  /// Both ends are WebSocketConnections.
  void open_both(ConnectionTimings timings = {}) {
    auto sockets = connected_sockets();
    server_ = open(std::move(sockets.ours), options(WebSocketRole::kServer, timings));
    client_ = open(std::move(sockets.theirs), options(WebSocketRole::kClient, timings));
  }

  /// The server is a WebSocketConnection; the test scripts the client byte by byte.
  void open_server(ConnectionTimings timings = {}) {
    auto sockets = connected_sockets();
    server_ = open(std::move(sockets.ours), options(WebSocketRole::kServer, timings));
    peer_.emplace(std::move(sockets.theirs));
  }

  void peer_sends(Opcode opcode, std::string_view payload = "") {
    const auto frame = frame_message(MessageBuffer(bytes_of(payload)), opcode, MaskKey{1, 2, 3, 4});
    boost::asio::write(*peer_,
                       boost::asio::buffer(frame->wire_bytes().data(), frame->wire_bytes().size()));
  }

  /// Reads the available bytes, at most a bufferful.
  void peer_takes(std::vector<char>& buffer) {
    boost::system::error_code nothing_there;
    peer_->non_blocking(true);
    peer_->read_some(boost::asio::buffer(buffer), nothing_there);
  }

  /// Frames that the peer has received, until the server ends or `count` have arrived.
  std::vector<std::string> peer_receives(std::size_t count) {
    WebSocketReader reader(WebSocketRole::kClient, 4 * kTwoMiB);
    std::vector<std::string> events;
    std::size_t used = 0;
    receive(*peer_, [&](const std::string& all) {
      std::span<const std::uint8_t> rest(reinterpret_cast<const std::uint8_t*>(all.data()) + used,
                                         all.size() - used);
      for (;;) {
        const ReaderEvent event = reader.next(rest);
        if (std::holds_alternative<NeedsMoreBytes>(event)) break;
        events.push_back(name(event));
      }
      used = all.size();
      return events.size() >= count;
    });
    return events;
  }

  static std::string name(const ReaderEvent& event) {
    if (const auto* message = std::get_if<MessageBuffer>(&event)) {
      return "message of " + std::to_string(message->size());
    }
    if (const auto* ping = std::get_if<Ping>(&event)) return "ping " + ping->payload;
    if (const auto* pong = std::get_if<Pong>(&event)) return "pong " + pong->payload;
    if (const auto* close = std::get_if<PeerClose>(&event)) {
      return "close " + std::to_string(close->code) + " " + close->reason;
    }
    return "violation";
  }

  End server_;
  End client_;
  std::optional<Tcp::socket> peer_;
};

}  // namespace roomcast::net
