// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cluster/nats_session_thread.h"

#include <utility>
#include <vector>

#include <boost/asio/post.hpp>
#include <sys/socket.h>
#include <unistd.h>

namespace roomcast::cluster {

namespace asio = boost::asio;

Result<std::shared_ptr<NatsServerLink>> NatsSessionThread::connect(const NatsOptions& options,
                                                                   asio::io_context& rooms) {
  std::shared_ptr<NatsSessionThread> made(new NatsSessionThread(rooms));
  auto session = NatsSession::connect(options, made->own_);
  if (!session) return session.error();
  made->session_ = *std::move(session);
  made->max_message_bytes_ = made->session_->max_message_bytes();
  made->server_ = made->session_->server();
  made->socket_ = made->session_->duplicate_socket();
  return std::shared_ptr<NatsServerLink>(std::move(made));
}

NatsSessionThread::~NatsSessionThread() {
  stop();
  if (socket_ >= 0) ::close(socket_);
}

template <class Tell>
void NatsSessionThread::tell_rooms(Tell tell) {
  asio::post(rooms_, [weak = weak_from_this(), tell = std::move(tell)]() mutable {
    const auto self = weak.lock();
    if (self && !self->is_stopped_) tell(*self);
  });
}

void NatsSessionThread::start(Handlers handlers) {
  handlers_ = std::move(handlers);
  asio::post(own_, [this] {
    session_->start(
        {.on_messages =
             [this](std::vector<NatsMessagePtr> messages) {
               tell_rooms([messages = std::move(messages)](auto& self) mutable {
                 self.handlers_.on_messages(std::move(messages));
               });
             },
         .on_gone = [this] { tell_rooms([](auto& self) { self.handlers_.on_gone(); }); }});
  });
  thread_ = std::jthread([this] { own_.run(); });
}

void NatsSessionThread::stop() {
  if (std::exchange(is_stopped_, true) || !thread_.joinable()) return;
  std::promise<void> stopped;
  asio::post(own_, [this, &stopped] {
    session_->stop();
    stopped.set_value();
  });
  auto is_stopped = stopped.get_future();
  if (is_stopped.wait_for(kStopWithin) != std::future_status::ready) abort();
  is_stopped.wait();
  busy_.reset();
  own_.stop();
  thread_.join();
}

void NatsSessionThread::subscribe(const std::string& subject) {
  asio::post(own_, [this, subject] { session_->subscribe(subject); });
}

void NatsSessionThread::unsubscribe(const std::string& subject) {
  asio::post(own_, [this, subject] { session_->unsubscribe(subject); });
}

bool NatsSessionThread::publish(const std::string& subject, std::span<const std::uint8_t> message,
                                std::size_t max_waiting_bytes) {
  if (waiting_bytes_ + message.size() > max_waiting_bytes) return false;
  waiting_bytes_ += message.size();
  asio::post(own_, [this, subject, max_waiting_bytes,
                    bytes = std::vector<std::uint8_t>(message.begin(), message.end())] {
    waiting_bytes_ -= bytes.size();
    session_->publish(subject, bytes, max_waiting_bytes);
  });
  return true;
}

void NatsSessionThread::ask() {
  asio::post(own_, [this] { session_->ask(); });
}

/// Whatever waits for the socket waits no more.
void NatsSessionThread::abort() {
  ::shutdown(socket_, SHUT_RDWR);
}

Result<std::shared_ptr<NatsServerLink>> connect_to_nats(const NatsOptions& options,
                                                        asio::io_context& rooms) {
  if (wants_tls(options)) return NatsSessionThread::connect(options, rooms);
  auto session = NatsSession::connect(options, rooms);
  if (!session) return session.error();
  return std::shared_ptr<NatsServerLink>(*std::move(session));
}

}  // namespace roomcast::cluster
