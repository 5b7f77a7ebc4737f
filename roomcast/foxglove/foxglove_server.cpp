// SPDX-License-Identifier: Apache-2.0
#include "roomcast/foxglove/foxglove_server.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include "roomcast/foxglove/client_connection.h"
#include "roomcast/foxglove/subscriptions.h"

namespace roomcast::foxglove {

namespace asio = boost::asio;
using Tcp = asio::ip::tcp;

bool allows_origin(std::string_view origin, const std::vector<std::string>& known) {
  if (std::ranges::find(known, origin) != known.end()) return true;
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (!origin.starts_with(scheme)) continue;
    const std::string_view host = origin.substr(scheme.size());
    for (const std::string_view own : {"localhost", "127.0.0.1", "[::1]"}) {
      if (host == own || (host.starts_with(own) && host[own.size()] == ':')) return true;
    }
  }
  return false;
}

/// The server's thread and all that it owns.
class FoxgloveServer::Loop final : public ConnectionOwner {
 public:
  explicit Loop(FoxgloveServerOptions options)
      : options_(std::move(options)),
        // A new server has a new identity, so clients forget the channels of an older one.
        server_info_(foxglove::server_info(
            options_.name,
            std::to_string(std::chrono::system_clock::now().time_since_epoch().count()))) {}

  ~Loop() override {
    io_.stop();
    if (thread_.joinable()) thread_.join();
    for (const auto& connection : connections_) connection->stop();
  }

  Status listen() {
    boost::system::error_code error;
    const auto address = asio::ip::make_address(options_.address, error);
    if (error) return invalid_argument("\"" + options_.address + "\" is not a numeric address");
    const Tcp::endpoint endpoint(address, options_.port);
    acceptor_.open(endpoint.protocol(), error);
    if (!error) acceptor_.set_option(Tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (error)
      return Error{ErrorCode::kUnavailable, "cannot listen on " + options_.address + ":" +
                                                std::to_string(options_.port) + ": " +
                                                error.message()};
    port_ = acceptor_.local_endpoint().port();
    accept();
    thread_ = std::jthread([this] { io_.run(); });
    return {};
  }

  [[nodiscard]] std::uint16_t port() const { return port_; }

  void set_channels(std::vector<Channel> channels) {
    asio::post(io_, [this, channels = std::move(channels)] { replace_channels(channels); });
  }

  [[nodiscard]] std::set<ChannelId> wanted() const {
    const std::lock_guard lock(mutex_);
    return wanted_;
  }

  void publish(ChannelId channel, TopicMessagePtr message) {
    const std::lock_guard lock(mutex_);
    mailboxes_[channel] = std::move(message);
    if (!std::exchange(delivery_posted_, true)) asio::post(io_, [this] { deliver(); });
  }

  // ConnectionOwner, on the server's thread
  [[nodiscard]] const std::string& server_info() const override { return server_info_; }
  [[nodiscard]] const std::vector<Channel>& channels() const override { return channels_; }
  [[nodiscard]] bool allows(std::string_view origin) const override {
    return allows_origin(origin, options_.origins);
  }
  void on_subscriptions_changed() override {
    std::set<ChannelId> wanted;
    for (const auto& connection : connections_) {
      for (const ChannelId channel : connection->subscriptions().channels()) wanted.insert(channel);
    }
    const std::lock_guard lock(mutex_);
    wanted_ = std::move(wanted);
  }
  void on_ended(const std::shared_ptr<ClientConnection>& connection) override {
    connections_.erase(connection);
    on_subscriptions_changed();
    if (const auto skipped = connection->subscriptions().skipped(); options_.log && skipped > 0)
      options_.log(LogLevel::kInfo, "a client left, for which " + std::to_string(skipped) +
                                        " messages were replaced by newer ones");
  }

 private:
  void accept() {
    acceptor_.async_accept([this](boost::system::error_code error, Tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (error) return accept_later();
      if (connections_.size() < options_.max_clients) {
        const auto connection = std::make_shared<ClientConnection>(std::move(socket), *this);
        connections_.insert(connection);
        connection->start();
      }
      accept();
    });
  }

  /// Too many open files, for example: trying again at once would only be busy.
  void accept_later() {
    retry_.expires_after(std::chrono::milliseconds(100));
    retry_.async_wait([this](boost::system::error_code error) {
      if (!error) accept();
    });
  }

  void replace_channels(const std::vector<Channel>& channels) {
    const auto missing_in = [](const std::vector<Channel>& list) {
      return [&list](const Channel& channel) {
        return std::ranges::find(list, channel.id, &Channel::id) == list.end();
      };
    };
    std::vector<ChannelId> gone;
    for (const Channel& channel : channels_) {
      if (missing_in(channels)(channel)) gone.push_back(channel.id);
    }
    std::vector<Channel> added;
    std::ranges::copy_if(channels, std::back_inserter(added), missing_in(channels_));
    channels_ = channels;
    for (const auto& connection : std::vector(connections_.begin(), connections_.end())) {
      if (!gone.empty()) connection->unadvertise(gone);
      if (!added.empty()) connection->advertise(added);
    }
    on_subscriptions_changed();
  }

  void deliver() {
    std::map<ChannelId, TopicMessagePtr> messages;
    {
      const std::lock_guard lock(mutex_);
      messages.swap(mailboxes_);
      delivery_posted_ = false;
    }
    for (const auto& connection : std::vector(connections_.begin(), connections_.end())) {
      for (const auto& [channel, message] : messages) connection->offer(channel, message);
    }
  }

  const FoxgloveServerOptions options_;
  const std::string server_info_;
  asio::io_context io_{1};
  Tcp::acceptor acceptor_{io_};
  asio::steady_timer retry_{io_};
  std::uint16_t port_ = 0;
  std::set<std::shared_ptr<ClientConnection>> connections_;
  std::vector<Channel> channels_;

  mutable std::mutex mutex_;
  std::set<ChannelId> wanted_;
  std::map<ChannelId, TopicMessagePtr> mailboxes_;
  bool delivery_posted_ = false;

  std::jthread thread_;
};

Result<std::unique_ptr<FoxgloveServer>> FoxgloveServer::listen(FoxgloveServerOptions options) {
  auto loop = std::make_unique<Loop>(std::move(options));
  if (auto status = loop->listen(); !status) return status.error();
  return std::unique_ptr<FoxgloveServer>(new FoxgloveServer(std::move(loop)));
}

FoxgloveServer::FoxgloveServer(std::unique_ptr<Loop> loop) : loop_(std::move(loop)) {}
FoxgloveServer::~FoxgloveServer() = default;

std::uint16_t FoxgloveServer::port() const {
  return loop_->port();
}
void FoxgloveServer::set_channels(std::vector<Channel> channels) {
  loop_->set_channels(std::move(channels));
}
std::set<ChannelId> FoxgloveServer::wanted() const {
  return loop_->wanted();
}
void FoxgloveServer::publish(ChannelId channel, nanoseconds time, std::string message) {
  loop_->publish(channel,
                 std::make_shared<const TopicMessage>(TopicMessage{time, std::move(message)}));
}

}  // namespace roomcast::foxglove
