// SPDX-License-Identifier: Apache-2.0
// ClientConnection: one client of a FoxgloveServer, from its handshake to its end. Its requests and
// the lists of channels are text messages, so it uses Boost.Beast's WebSocket: net's own carries
// binary messages only (docs/adr/0005-websocket-writer-of-our-own.md). Threading: runs on the one
// thread of its io_context.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "roomcast/foxglove/protocol.h"
#include "roomcast/foxglove/subscriptions.h"

namespace roomcast::foxglove {

/// What a connection needs to know of its server.
class ConnectionOwner {
 public:
  virtual ~ConnectionOwner() = default;
  [[nodiscard]] virtual const std::string& server_info() const = 0;
  [[nodiscard]] virtual const std::vector<Channel>& channels() const = 0;
  /// Whether a page of this site may connect.
  [[nodiscard]] virtual bool allows(std::string_view origin) const = 0;
  virtual void on_subscriptions_changed() = 0;
  /// The connection has ended. Called once.
  virtual void on_ended(const std::shared_ptr<class ClientConnection>& connection) = 0;
};

class ClientConnection : public std::enable_shared_from_this<ClientConnection> {
 public:
  /// `owner` outlives the connection's last callback, or stop() is called before.
  ClientConnection(boost::asio::ip::tcp::socket socket, ConnectionOwner& owner);

  /// Waits for the request.
  void start();
  /// Ends at once. The owner is not called any more.
  void stop();

  /// No effect before the handshake is done; the client gets the list of channels then.
  void advertise(std::span<const Channel> channels);
  void unadvertise(std::span<const ChannelId> channels);
  void offer(ChannelId channel, const TopicMessagePtr& message);

  [[nodiscard]] const Subscriptions& subscriptions() const { return subscriptions_; }

 private:
  using ErrorCode = boost::system::error_code;
  using Stream = boost::beast::websocket::stream<boost::beast::tcp_stream>;

  void on_request(ErrorCode error);
  void refuse(unsigned status, const std::string& sentence);
  void on_open();
  void read();
  void take(std::string_view text);
  void subscribe(const std::vector<Subscription>& wanted);
  void unsubscribe(const std::vector<std::uint32_t>& ids);
  void say(std::string text);
  void write();
  void end();

  Stream stream_;
  ConnectionOwner* owner_;  // null: stopped, or ended
  boost::beast::flat_buffer received_;
  boost::beast::http::request_parser<boost::beast::http::empty_body> parser_;
  boost::beast::http::response<boost::beast::http::string_body> refusal_;
  std::deque<std::string> texts_;  // to be sent, before all topics
  Subscriptions subscriptions_;
  bool open_ = false;
  bool writing_ = false;
  std::string text_being_written_;
  std::array<std::uint8_t, 13> header_being_written_{};
  TopicMessagePtr message_being_written_;
};

}  // namespace roomcast::foxglove
