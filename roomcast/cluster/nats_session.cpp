// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cluster/nats_session.h"

#include <algorithm>

#include <sys/socket.h>
#include <unistd.h>

namespace roomcast::cluster {

namespace asio = boost::asio;

Result<std::shared_ptr<NatsSession>> NatsSession::connect(const NatsOptions& options,
                                                          asio::io_context& io) {
  auto libnats = libnats_options(options);
  if (!libnats) return libnats.error();
  std::shared_ptr<NatsSession> session(new NatsSession(io));
  natsOptions_SetEventLoop(libnats->get(), session.get(), attach, read_wanted, write_wanted,
                           detach);
  natsConnection* made = nullptr;
  const natsStatus status = natsConnection_Connect(&made, libnats->get());
  session->connection_.reset(made);
  if (status != NATS_OK) return connect_error(status, options);
  session->last_heard_ = session->clock_.now();
  return session;
}

NatsSession::~NatsSession() {
  stop();
}

/// Once libnats is connected, still on its thread.
natsStatus NatsSession::attach(void** user_data, void* session, natsConnection*, natsSock fd) {
  *user_data = session;
  boost::system::error_code ignored;
  static_cast<NatsSession*>(session)->socket_.assign(::dup(fd), ignored);
  return NATS_OK;
}

void NatsSession::start(Handlers handlers) {
  handlers_ = std::move(handlers);
  read_later();
}

void NatsSession::stop() {
  is_over_ = true;
  if (connection_) close_now();
  subscriptions_.clear();
  connection_.reset();
  boost::system::error_code ignored;
  socket_.close(ignored);
}

/// libnats would wait for a server to take what is still to be written.
void NatsSession::close_now() {
  natsConnection_ProcessWriteEvent(connection_.get());
  if (natsConnection_Buffered(connection_.get()) > 0) abort();
  while (natsConnection_Buffered(connection_.get()) > 0 &&
         !natsConnection_IsClosed(connection_.get())) {
    natsConnection_ProcessReadEvent(connection_.get());  // up to the end that abort() has made
  }
  natsConnection_Close(connection_.get());
}

int NatsSession::duplicate_socket() {
  return ::dup(socket_.native_handle());
}

void NatsSession::abort() {
  ::shutdown(socket_.native_handle(), SHUT_RDWR);
}

// ---- reading

void NatsSession::read_later() {
  socket_.async_wait(asio::posix::stream_descriptor::wait_read,
                     [weak = weak_from_this()](boost::system::error_code error) {
                       const auto self = weak.lock();
                       if (self && !error && self->connection_) self->read();
                     });
}

void NatsSession::read() {
  natsConnection_ProcessReadEvent(connection_.get());
  last_heard_ = clock_.now();
  if (natsConnection_Buffered(connection_.get()) > 0) write();  // an answer: the server asked, too
  auto messages = take_messages();
  if (!messages.empty() && !is_over_) handlers_.on_messages(std::move(messages));
  if (connection_ && !end_if_closed()) read_later();
}

/// Those of newer subscriptions first: what is said on them is told of on older ones.
std::vector<NatsMessagePtr> NatsSession::take_messages() {
  std::vector<NatsMessagePtr> messages;
  for (auto entry = subscriptions_.rbegin(); entry != subscriptions_.rend(); ++entry) {
    int waiting = 0, bytes = 0;  // libnats makes up a sentence where there is nothing
    natsSubscription_GetPending(entry->second.get(), &waiting, &bytes);
    natsMsg* message = nullptr;
    while (waiting-- > 0 && natsSubscription_NextMsg(&message, entry->second.get(), 0) == NATS_OK) {
      messages.emplace_back(message, &natsMsg_Destroy);
    }
  }
  return messages;
}

bool NatsSession::end_if_closed() {
  if (!natsConnection_IsClosed(connection_.get())) return false;
  if (!std::exchange(is_over_, true)) handlers_.on_gone();
  return true;
}

// ---- writing

void NatsSession::subscribe(const std::string& subject) {
  natsSubscription* made = nullptr;
  if (natsConnection_SubscribeSync(&made, connection_.get(), subject.c_str()) == NATS_OK) {
    subscriptions_.emplace_back(subject, SubscriptionPtr(made, &natsSubscription_Destroy));
  }
  write();
}

void NatsSession::unsubscribe(const std::string& subject) {
  std::erase_if(subscriptions_, [&](const auto& entry) { return entry.first == subject; });
  write();
}

bool NatsSession::publish(const std::string& subject, std::span<const std::uint8_t> message,
                          std::size_t max_waiting_bytes) {
  const int waiting = natsConnection_Buffered(connection_.get());
  if (waiting > 0 && static_cast<std::size_t>(waiting) > max_waiting_bytes) return false;
  natsConnection_Publish(connection_.get(), subject.c_str(), message.data(),
                         static_cast<int>(message.size()));
  write();
  return true;
}

/// libnats has no question that does not wait for its answer: it waits in vain, as short as it can,
/// for it is this thread that reads.
void NatsSession::ask() {
  if (!connection_) return;
  natsConnection_FlushTimeout(connection_.get(), 1);
  write();
}

void NatsSession::write() {
  if (!connection_ || waits_to_write_) return;
  natsConnection_ProcessWriteEvent(connection_.get());
  if (end_if_closed() || natsConnection_Buffered(connection_.get()) <= 0) return;
  waits_to_write_ = true;
  socket_.async_wait(asio::posix::stream_descriptor::wait_write,
                     [weak = weak_from_this()](boost::system::error_code error) {
                       const auto self = weak.lock();
                       if (!self || error) return;
                       self->waits_to_write_ = false;
                       self->write();
                     });
}

// ---- the server

std::size_t NatsSession::max_message_bytes() const {
  return static_cast<std::size_t>(natsConnection_GetMaxPayload(connection_.get()));
}

std::string NatsSession::server() const {
  char url[256] = "";
  natsConnection_GetConnectedUrl(connection_.get(), url, sizeof url);
  return without_secret(url);
}

}  // namespace roomcast::cluster
