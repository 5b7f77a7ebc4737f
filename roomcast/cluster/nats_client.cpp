// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cluster/nats_client.h"

#include <atomic>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

namespace roomcast::cluster {
namespace {

namespace asio = boost::asio;

constexpr std::chrono::milliseconds kTryAgainAfter{500};
constexpr std::size_t kUsualMessageBytes = 1u << 20;

using MessagePtr = std::unique_ptr<natsMsg, decltype(&natsMsg_Destroy)>;

std::span<const std::uint8_t> bytes_of(const natsMsg* message) {
  return {reinterpret_cast<const std::uint8_t*>(natsMsg_GetData(message)),
          static_cast<std::size_t>(natsMsg_GetDataLength(message))};
}

}  // namespace

// Messages on their way from libnats' thread to ours. libnats may call back a last time while a
// connection is being closed, so each subscription and connection holds one of these.
class Inlet {
 public:
  Inlet(asio::io_context& io, NatsHandlers handlers) : io_(io), handlers_(std::move(handlers)) {}

  /// From libnats' thread.
  void put(const std::shared_ptr<Inlet>& self, MessagePtr message) {
    const std::lock_guard lock(mutex_);
    const std::size_t size = bytes_of(message.get()).size();
    if (is_closed_ || bytes_ + size > NatsClient::kMaxUnhandledBytes) return;
    bytes_ += size;
    messages_.push_back(std::move(message));
    if (messages_.size() == 1) asio::post(io_, [self] { self->handle(); });
  }
  void tell_connected(const std::shared_ptr<Inlet>& self) {
    const std::lock_guard lock(mutex_);
    if (is_closed_) return;
    asio::post(io_, [self] {
      if (!self->is_closed_ && self->handlers_.on_connected) self->handlers_.on_connected();
    });
  }
  void log(LogLevel level, const std::string& line) const {
    if (handlers_.log) handlers_.log(level, line);
  }

  /// On the thread that runs `io`: nothing is handled after this.
  void close() {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    messages_.clear();
  }

 private:
  void handle() {
    std::vector<MessagePtr> messages;
    {
      const std::lock_guard lock(mutex_);
      messages.swap(messages_);
      bytes_ = 0;
    }
    for (const MessagePtr& message : messages) {
      if (is_closed_) return;
      handlers_.on_message(natsMsg_GetSubject(message.get()), bytes_of(message.get()));
    }
  }

  asio::io_context& io_;
  const NatsHandlers handlers_;
  std::mutex mutex_;
  std::vector<MessagePtr> messages_;
  std::size_t bytes_ = 0;
  std::atomic<bool> is_closed_ = false;
};

namespace {

/// What libnats calls back with; deleted by its last call.
using Closure = std::shared_ptr<Inlet>;

void on_message(natsConnection*, natsSubscription*, natsMsg* message, void* closure) {
  const Closure& inlet = *static_cast<Closure*>(closure);
  inlet->put(inlet, MessagePtr(message, &natsMsg_Destroy));
}

void on_subscription_complete(void* closure) {
  delete static_cast<Closure*>(closure);
}

void on_disconnected(natsConnection*, void* closure) {
  (*static_cast<Closure*>(closure))->log(LogLevel::kWarning, "the NATS node is gone");
}

void on_reconnected(natsConnection* connection, void* closure) {
  const Closure& inlet = *static_cast<Closure*>(closure);
  char url[256] = "";
  natsConnection_GetConnectedUrl(connection, url, sizeof url);
  inlet->log(LogLevel::kInfo, "goes on at the NATS node " + without_secret(url));
  inlet->tell_connected(inlet);
}

void on_closed(natsConnection*, void* closure) {
  delete static_cast<Closure*>(closure);
}

void on_error(natsConnection*, natsSubscription*, natsStatus error, void* closure) {
  (*static_cast<Closure*>(closure))
      ->log(LogLevel::kWarning, std::string("NATS: ") + natsStatus_GetText(error));
}

}  // namespace

// Its connection is used on its own thread only, but for the first.
class NatsClient::Link {
 public:
  Link(NatsOptions options, NatsOptionsPtr libnats, std::shared_ptr<Inlet> inlet)
      : options_(std::move(options)), libnats_(std::move(libnats)), inlet_(std::move(inlet)) {}
  ~Link() {
    inlet_->close();
    asio::post(io_, [this] { timer_.cancel(); });
    work_.reset();
    thread_ = {};  // what was said is written
    if (connection_ == nullptr) return;
    for (auto& [subject, subscription] : subscriptions_) natsSubscription_Destroy(subscription);
    natsConnection_Destroy(connection_);
  }

  Status connect() {
    auto closure = std::make_unique<Closure>(inlet_);
    natsOptions_SetDisconnectedCB(libnats_.get(), on_disconnected, closure.get());
    natsOptions_SetReconnectedCB(libnats_.get(), on_reconnected, closure.get());
    natsOptions_SetClosedCB(libnats_.get(), on_closed, closure.get());
    natsOptions_SetErrorHandler(libnats_.get(), on_error, closure.get());
    const natsStatus status = natsConnection_Connect(&connection_, libnats_.get());
    if (status != NATS_OK) return connect_error(status, options_);
    (void)closure.release();  // on_closed has it
    max_message_bytes_ = static_cast<std::size_t>(natsConnection_GetMaxPayload(connection_));
    inlet_->tell_connected(inlet_);
    return {};
  }

  void start() {
    watch_later();
    thread_ = std::jthread([this] { io_.run(); });
  }

  void subscribe(std::string subject) {
    asio::post(io_, [this, subject = std::move(subject)] {
      if (subscriptions_.emplace(subject, nullptr).second) subscribe_now(subject);
    });
  }
  void unsubscribe(std::string subject) {
    asio::post(io_, [this, subject = std::move(subject)] {
      const auto ended = subscriptions_.extract(subject);
      if (ended) natsSubscription_Destroy(ended.mapped());
    });
  }
  void publish(std::string subject, std::vector<std::uint8_t> message, bool keep) {
    const std::size_t size = message.size();
    if (waiting_bytes_ + size > kMaxWaitingBytes) return;
    waiting_bytes_ += size;
    asio::post(io_, [this, subject = std::move(subject), message = std::move(message), keep] {
      waiting_bytes_ -= message.size();
      if (connection_ == nullptr || (!keep && natsConnection_IsReconnecting(connection_))) return;
      natsConnection_Publish(connection_, subject.c_str(), message.data(),
                             static_cast<int>(message.size()));
    });
  }
  [[nodiscard]] std::size_t max_message_bytes() const { return max_message_bytes_; }

 private:
  void subscribe_now(const std::string& subject) {
    if (connection_ == nullptr) return;
    auto closure = std::make_unique<Closure>(inlet_);
    natsSubscription* made = nullptr;
    if (natsConnection_Subscribe(&made, connection_, subject.c_str(), on_message, closure.get()) !=
        NATS_OK) {
      return;
    }
    natsSubscription_SetOnCompleteCB(made, on_subscription_complete, closure.release());
    subscriptions_[subject] = made;
  }

  /// libnats gives up where it is refused, and never begins where no server was there at first.
  void watch_later() {
    timer_.expires_after(kTryAgainAfter);
    timer_.async_wait([this](boost::system::error_code error) {
      if (error) return;
      watch();
      watch_later();
    });
  }
  void watch() {
    if (connection_ != nullptr && !natsConnection_IsClosed(connection_)) return;
    for (auto& [subject, subscription] : subscriptions_) {
      natsSubscription_Destroy(std::exchange(subscription, nullptr));
    }
    natsConnection_Destroy(std::exchange(connection_, nullptr));
    const Status status = connect();
    if (!status && std::exchange(was_told_, status.error().message) != status.error().message) {
      inlet_->log(LogLevel::kWarning, status.error().message);
    }
    if (!status) return;
    was_told_.clear();
    for (const auto& entry : std::map(subscriptions_)) subscribe_now(entry.first);
  }

  const NatsOptions options_;
  const NatsOptionsPtr libnats_;
  const std::shared_ptr<Inlet> inlet_;
  natsConnection* connection_ = nullptr;
  std::map<std::string, natsSubscription*> subscriptions_;  // null: not subscribed to
  std::string was_told_;
  std::atomic<std::size_t> waiting_bytes_ = 0, max_message_bytes_ = kUsualMessageBytes;
  asio::io_context io_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_ = asio::make_work_guard(io_);
  asio::steady_timer timer_{io_};
  std::jthread thread_;
};

Result<std::unique_ptr<NatsClient>> NatsClient::open(NatsOptions options, asio::io_context& io,
                                                     NatsHandlers handlers) {
  if (auto status = check(options); !status) return status.error();
  auto libnats = libnats_options(options);
  if (!libnats) return libnats.error();
  auto inlet = std::make_shared<Inlet>(io, std::move(handlers));
  auto link = std::make_shared<Link>(std::move(options), *std::move(libnats), inlet);
  if (auto status = link->connect(); !status) {
    if (status.error().code != ErrorCode::kUnavailable) return status.error();
    inlet->log(LogLevel::kWarning, status.error().message + "; goes on trying");
  }
  link->start();
  return std::unique_ptr<NatsClient>(new NatsClient(std::move(link)));
}

NatsClient::NatsClient(std::shared_ptr<Link> link) : link_(std::move(link)) {}
NatsClient::~NatsClient() = default;

void NatsClient::subscribe(std::string subject) {
  link_->subscribe(std::move(subject));
}

void NatsClient::unsubscribe(std::string subject) {
  link_->unsubscribe(std::move(subject));
}

void NatsClient::publish(std::string subject, std::vector<std::uint8_t> message) {
  link_->publish(std::move(subject), std::move(message), true);
}

void NatsClient::publish_now(std::string subject, std::vector<std::uint8_t> message) {
  link_->publish(std::move(subject), std::move(message), false);
}

std::size_t NatsClient::max_message_bytes() const {
  return link_->max_message_bytes();
}

}  // namespace roomcast::cluster
