// SPDX-License-Identifier: Apache-2.0
#include "roomcast/foxglove/client_connection.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "roomcast/net/allowed_names.h"
#include "roomcast/net/websocket_handshake.h"

namespace roomcast::foxglove {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;

constexpr std::chrono::seconds kRequestWithin{5};
constexpr std::size_t kMaxHeaderBytes = 8 * 1024;
/// A client that asks without reading the answers is ended.
constexpr std::size_t kMaxTexts = 256;
/// Little, so that what waits in the kernel is not old.
constexpr int kSendBufferBytes = 512 * 1024;

std::string_view field_of(const net::RequestHeader& request, http::field name) {
  const auto value = request[name];
  return {value.data(), value.size()};
}

}  // namespace

ClientConnection::ClientConnection(asio::ip::tcp::socket socket, ConnectionOwner& owner)
    : stream_(std::move(socket)), owner_(&owner) {
  ErrorCode ignored;
  auto& tcp = stream_.next_layer().socket();
  tcp.set_option(asio::ip::tcp::no_delay(true), ignored);
  tcp.set_option(asio::socket_base::send_buffer_size(kSendBufferBytes), ignored);
  parser_.header_limit(kMaxHeaderBytes);
  parser_.body_limit(0);
}

void ClientConnection::start() {
  stream_.next_layer().expires_after(kRequestWithin);
  http::async_read(
      stream_.next_layer(), received_, parser_,
      [self = shared_from_this()](ErrorCode error, std::size_t) { self->on_request(error); });
}

void ClientConnection::stop() {
  owner_ = nullptr;
  ErrorCode ignored;
  stream_.next_layer().socket().close(ignored);
}

void ClientConnection::on_request(ErrorCode error) {
  if (owner_ == nullptr) return;
  if (error) return end();
  const net::RequestHeader& request = parser_.get();
  net::AllowedNames names;
  if (!names.allows_host(field_of(request, http::field::host)))
    return refuse(421, "This server is called by its numeric address, or localhost.\n");
  if (!net::asks_for_websocket(request))
    return refuse(426, "This is a server for Foxglove: open its address there.\n");
  const std::string_view origin = field_of(request, http::field::origin);
  if (owner_->allows(origin)) names.origins.emplace_back(origin);
  if (const auto refusal = net::refuse_upgrade(request, kSubprotocol, names))
    return refuse(static_cast<unsigned>(refusal->status), *refusal->body);
  stream_.next_layer().expires_never();  // the WebSocket has limits of its own
  stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
  stream_.set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
    response.set(http::field::sec_websocket_protocol,
                 beast::string_view(kSubprotocol.data(), kSubprotocol.size()));
  }));
  stream_.read_message_max(kMaxRequestBytes);
  stream_.auto_fragment(false);  // a message is one write
  stream_.async_accept(parser_.get(), [self = shared_from_this()](ErrorCode failed) {
    if (self->owner_ == nullptr) return;
    failed ? self->end() : self->on_open();
  });
}

void ClientConnection::refuse(unsigned status, const std::string& sentence) {
  refusal_.version(11);
  refusal_.result(status);
  refusal_.set(http::field::content_type, "text/plain; charset=utf-8");
  if (status == 426) refusal_.set(http::field::upgrade, "websocket");
  refusal_.body() = sentence;
  refusal_.keep_alive(false);
  refusal_.prepare_payload();
  http::async_write(
      stream_.next_layer(), refusal_, [self = shared_from_this()](ErrorCode, std::size_t) {
        ErrorCode ignored;
        self->stream_.next_layer().socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
        self->end();
      });
}

void ClientConnection::on_open() {
  open_ = true;
  received_.clear();
  say(owner_->server_info());
  advertise(owner_->channels());
  read();
}

void ClientConnection::read() {
  stream_.async_read(received_, [self = shared_from_this()](ErrorCode error, std::size_t) {
    if (self->owner_ == nullptr) return;
    if (error) return self->end();
    if (self->stream_.got_text()) {
      const auto bytes = self->received_.cdata();
      self->take({static_cast<const char*>(bytes.data()), bytes.size()});
    } else {
      self->say(status(Level::kError, "This server takes no messages for topics."));
    }
    self->received_.clear();
    if (self->owner_ != nullptr) self->read();
  });
}

void ClientConnection::take(std::string_view text) {
  const auto request = parse_request(text);
  if (!request) return say(status(Level::kError, request.error().message));
  unsubscribe(request->unsubscribe);
  subscribe(request->subscribe);
  if (owner_ != nullptr) owner_->on_subscriptions_changed();
}

void ClientConnection::subscribe(const std::vector<Subscription>& wanted) {
  for (const Subscription& subscription : wanted) {
    if (owner_ == nullptr) return;
    if (!std::ranges::any_of(owner_->channels(), [&](const Channel& channel) {
          return channel.id == subscription.channel;
        })) {
      say(status(Level::kError,
                 "There is no channel " + std::to_string(subscription.channel.value) + "."));
    } else if (const auto added = subscriptions_.add(subscription); !added) {
      say(status(Level::kError, added.error().message));
    }
  }
}

void ClientConnection::unsubscribe(const std::vector<std::uint32_t>& ids) {
  for (const std::uint32_t id : ids) {
    if (!subscriptions_.remove(id))
      say(status(Level::kWarning, "There is no subscription " + std::to_string(id) + "."));
  }
}

void ClientConnection::advertise(std::span<const Channel> channels) {
  if (open_) say(foxglove::advertise(channels));
}

void ClientConnection::unadvertise(std::span<const ChannelId> channels) {
  for (const ChannelId channel : channels) subscriptions_.drop(channel);
  if (open_) say(foxglove::unadvertise(channels));
}

void ClientConnection::offer(ChannelId channel, const TopicMessagePtr& message) {
  subscriptions_.offer(channel, message);
  write();
}

void ClientConnection::say(std::string text) {
  if (owner_ == nullptr) return;
  if (texts_.size() >= kMaxTexts) return end();
  texts_.push_back(std::move(text));
  write();
}

void ClientConnection::write() {
  if (!open_ || writing_ || owner_ == nullptr) return;
  std::array<asio::const_buffer, 2> buffers;
  if (!texts_.empty()) {
    text_being_written_ = std::move(texts_.front());
    texts_.pop_front();
    stream_.text(true);
    buffers[0] = asio::buffer(text_being_written_);
  } else if (auto next = subscriptions_.next()) {
    message_being_written_ = std::move(next->message);
    header_being_written_ = data_header(next->subscription, message_being_written_->time);
    stream_.binary(true);
    buffers = {asio::buffer(header_being_written_), asio::buffer(message_being_written_->bytes)};
  } else {
    return;
  }
  writing_ = true;
  stream_.async_write(buffers, [self = shared_from_this()](ErrorCode error, std::size_t) {
    self->writing_ = false;
    self->message_being_written_.reset();
    if (self->owner_ == nullptr) return;
    error ? self->end() : self->write();
  });
}

void ClientConnection::end() {
  ConnectionOwner* const owner = std::exchange(owner_, nullptr);
  ErrorCode ignored;
  stream_.next_layer().socket().close(ignored);
  if (owner != nullptr) owner->on_ended(shared_from_this());
}

}  // namespace roomcast::foxglove
