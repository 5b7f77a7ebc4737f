// SPDX-License-Identifier: Apache-2.0
#include <deque>
#include <functional>
#include <set>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "bench/fanout/engine.h"

namespace roomcast::bench {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using Message = std::shared_ptr<const std::string>;

class Room;

class Client : public std::enable_shared_from_this<Client> {
 public:
  Client(Tcp::socket socket, Room& room) : stream_(std::move(socket)), room_(room) {}
  void start();
  void send(const Message& message) {
    waiting_.push_back(message);
    if (waiting_.size() == 1) write();
  }

 private:
  void read();
  void write();

  websocket::stream<beast::tcp_stream> stream_;
  Room& room_;
  beast::flat_buffer buffer_;
  std::deque<Message> waiting_;
};

/// Treats a client that sends a message of frame size as a publisher; all other clients receive it.
class Room {
 public:
  explicit Room(std::size_t frame_bytes) : frame_bytes_(frame_bytes) {}

  [[noreturn]] void run(const ChildProcess::PortReport& report) {
    report(acceptor_.local_endpoint().port());
    accept();
    io_.run();
    std::abort();
  }
  void enter(const std::shared_ptr<Client>& client) { clients_.insert(client); }
  void leave(const std::shared_ptr<Client>& client) { clients_.erase(client); }
  void take(const std::shared_ptr<Client>& from, std::string_view message) {
    if (message.size() != frame_bytes_) return;
    clients_.erase(from);
    const auto shared = std::make_shared<const std::string>(message);
    for (const auto& client : clients_) client->send(shared);
  }

 private:
  void accept() {
    acceptor_.async_accept([this](boost::system::error_code error, Tcp::socket socket) {
      if (!error) std::make_shared<Client>(std::move(socket), *this)->start();
      accept();
    });
  }

  const std::size_t frame_bytes_;
  asio::io_context io_{1};
  Tcp::acceptor acceptor_{io_, Tcp::endpoint(asio::ip::address_v4::loopback(), 0)};
  std::set<std::shared_ptr<Client>> clients_;
};

void Client::start() {
  stream_.binary(true);
  stream_.set_option(websocket::stream_base::decorator([](websocket::response_type& answer) {
    answer.set(beast::http::field::sec_websocket_protocol, "roomcast.v1");
  }));
  stream_.async_accept([self = shared_from_this()](boost::system::error_code error) {
    if (error) return;
    self->room_.enter(self);
    self->read();
  });
}

void Client::read() {
  stream_.async_read(buffer_, [self = shared_from_this()](auto error, std::size_t) {
    if (error) return self->room_.leave(self);
    const auto data = self->buffer_.cdata();
    self->room_.take(self, {static_cast<const char*>(data.data()), data.size()});
    self->buffer_.consume(self->buffer_.size());
    self->read();
  });
}

void Client::write() {
  stream_.async_write(asio::buffer(*waiting_.front()),
                      [self = shared_from_this()](auto error, std::size_t) {
                        if (error) return self->room_.leave(self);
                        self->waiting_.pop_front();
                        if (!self->waiting_.empty()) self->write();
                      });
}

class BeastEngine final : public Engine {
 public:
  std::string name() const override { return "Beast as it comes"; }
  Result<RunningEngine> start(const FanoutRoom& room) const override {
    auto child = ChildProcess::fork_off(
        [&](const ChildProcess::PortReport& report) { Room(room.frame_bytes).run(report); });
    if (!child) return child.error();
    return RunningEngine{*std::move(child), roomcast_protocol(room.fps), std::nullopt};
  }
};

}  // namespace

std::unique_ptr<Engine> make_beast() {
  return std::make_unique<BeastEngine>();
}

}  // namespace roomcast::bench
