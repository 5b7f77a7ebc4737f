// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/nats/nats_login.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <span>
#include <utility>

#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>

#include "roomcast/hub/federation/nats/nats_credentials.h"
#include "roomcast/net/host_lookup.h"
#include "roomcast/net/tls/tls_context.h"

namespace roomcast::hub::federation {
namespace {

namespace asio = boost::asio;
using Tcp = asio::ip::tcp;
using SystemError = boost::system::error_code;

constexpr std::size_t kLoginReadBytes = 4096;

bool is_about_identity(std::string_view complaint) {
  std::string lower(complaint);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower.find("authori") != std::string::npos || lower.find("authenti") != std::string::npos;
}

std::string all_of(const std::vector<std::string>& servers) {
  std::string text;
  for (const std::string& server : servers) {
    text += (text.empty() ? "" : ", ") + without_secret(server);
  }
  return text;
}

/// Tries one server after another.
class Attempt final : public NatsLoginAttempt, public std::enable_shared_from_this<Attempt> {
 public:
  Attempt(asio::io_context& io, NatsOptions options, NatsLoginCallback callback)
      : io_(io),
        resolver_(io),
        deadline_(io),
        socket_(io),
        options_(std::move(options)),
        callback_(std::move(callback)) {}

  void start();
  void cancel() override;

 private:
  [[nodiscard]] const std::string& server() const { return options_.servers[server_ - 1]; }
  void try_next_server();
  void resolve();
  void connect_to(const Tcp::resolver::results_type& endpoints);
  void read();
  void take_events();
  [[nodiscard]] bool take(const NatsEvent& event);
  void on_info(std::string_view json);
  void encrypt();
  void introduce();
  void on_ended();
  void succeed();
  void fail(NatsFault fault) { fail(connect_error(fault, server(), options_)); }
  void fail(Error error);
  void finish(Result<NatsConnection> result);
  void close();

  /// Calls `next(*this, error)` unless the attempt has ended, or moved on to another server, by
  /// then.
  template <class Next>
  auto then(Next next) {
    return [self = shared_from_this(), at = server_, next](SystemError error = {}, const auto&...) {
      if (self->callback_ && self->server_ == at) next(*self, error);
    };
  }

  asio::io_context& io_;
  Tcp::resolver resolver_;
  asio::steady_timer deadline_;
  Tcp::socket socket_;                 // while connecting...
  std::optional<net::Stream> stream_;  // ...and afterwards
  const NatsOptions options_;
  NatsLoginCallback callback_;    // empty once the attempt has ended
  std::size_t server_ = 0;        // number of servers tried so far
  std::optional<Error> refusal_;  // the first error that a retry cannot resolve
  NatsAddress address_;
  NatsServerInfo info_;
  bool is_encrypted_ = false, is_introduced_ = false;
  std::vector<std::uint8_t> received_;
  std::string line_;
};

void Attempt::start() {
  asio::post(io_, then([](Attempt& self, SystemError) { self.try_next_server(); }));
}

void Attempt::cancel() {
  callback_ = nullptr;
  deadline_.cancel();
  resolver_.cancel();
  close();
}

void Attempt::try_next_server() {
  if (server_ == options_.servers.size()) {
    return finish(
        refusal_.value_or(connect_error(NatsFault::kNoAnswer, all_of(options_.servers), options_)));
  }
  ++server_;
  close();
  address_ = *parse_nats_address(server());
  received_.clear();
  is_encrypted_ = is_introduced_ = false;
  deadline_.expires_after(kConnectWithin);
  deadline_.async_wait(then([](Attempt& self, SystemError error) {
    if (!error) self.fail(NatsFault::kNoAnswer);
  }));
  resolve();
}

void Attempt::resolve() {
  net::look_up(resolver_, address_.host, address_.port,
               [self = shared_from_this(), at = server_](SystemError error, const auto& endpoints) {
                 if (!self->callback_ || self->server_ != at) return;
                 if (error) return self->fail(NatsFault::kNoAnswer);
                 self->connect_to(endpoints);
               });
}

void Attempt::connect_to(const Tcp::resolver::results_type& endpoints) {
  asio::async_connect(socket_, endpoints, then([](Attempt& self, SystemError error) {
                        if (error) return self.fail(NatsFault::kNoAnswer);
                        SystemError ignored;
                        self.socket_.set_option(Tcp::no_delay(true), ignored);
                        self.stream_.emplace(std::move(self.socket_));
                        self.read();
                      }));
}

void Attempt::read() {
  const std::size_t size = received_.size();
  received_.resize(size + kLoginReadBytes);
  stream_->async_read_some(
      asio::buffer(received_.data() + size, kLoginReadBytes),
      [self = shared_from_this(), at = server_, size](SystemError error, std::size_t more) {
        if (!self->callback_ || self->server_ != at) return;
        self->received_.resize(size + more);
        if (error) return self->on_ended();
        self->take_events();
      });
}

/// Processes all received events; bytes after PONG belong to the connection.
void Attempt::take_events() {
  for (std::span<const std::uint8_t> bytes = received_;;) {
    const NatsEvent event = next_nats_event(bytes);
    if (std::holds_alternative<NatsNeedsMore>(event)) break;
    if (std::holds_alternative<NatsViolation>(event)) return fail(NatsFault::kNotNats);
    const std::size_t taken = received_.size() - bytes.size();
    if (!take(event)) return;
    received_.erase(received_.begin(), received_.begin() + static_cast<std::ptrdiff_t>(taken));
    bytes = received_;
    if (std::holds_alternative<NatsPong>(event) && is_introduced_) return succeed();
  }
  read();
}

/// False: reading is to stop for now.
bool Attempt::take(const NatsEvent& event) {
  if (const auto* complaint = std::get_if<NatsServerError>(&event)) {
    fail(is_about_identity(complaint->text) ? NatsFault::kRefused : NatsFault::kRejected);
    return false;
  }
  const auto* info = std::get_if<NatsInfo>(&event);
  if (info == nullptr || is_introduced_) return true;
  on_info(info->json);
  return false;
}

void Attempt::on_info(std::string_view json) {
  const auto info = read_server_info(json);
  received_.clear();  // the server waits for an answer now
  if (!info) return fail(NatsFault::kNotNats);
  info_ = *info;
  const bool wants = wants_tls(options_);
  if (wants && !info_.offers_tls) return fail(NatsFault::kOffersNoTls);
  if (wants || info_.demands_tls) return encrypt();
  introduce();
}

void Attempt::encrypt() {
  const auto context = net::TlsClientContext::create({.authorities_file = options_.ca_file,
                                                      .certificate_file = options_.cert_file,
                                                      .key_file = options_.key_file});
  if (!context) return fail(context.error());
  const int socket = stream_->socket().native_handle();
  auto tls = net::TlsSession::connect(socket, **context, {address_.host, std::nullopt});
  if (!tls) return fail(tls.error());
  is_encrypted_ = true;
  auto plain = std::move(stream_->socket());
  stream_.emplace(std::move(plain), *std::move(tls));
  stream_->async_handshake(then([](Attempt& self, SystemError error) {
    if (error) return self.on_ended();
    self.introduce();
  }));
}

void Attempt::introduce() {
  NatsIdentity identity = address_.identity;
  if (!options_.credentials_file.empty()) {
    const auto credentials = NatsCredentials::load(options_.credentials_file);
    if (!credentials) return fail(credentials.error());
    identity.user_jwt = credentials->user_jwt();
    if (!info_.nonce.empty()) identity.signature = credentials->sign(info_.nonce);
  }
  is_introduced_ = true;
  line_ = connect_line(identity, is_encrypted_) + std::string(kNatsPing);
  asio::async_write(*stream_, asio::buffer(line_), then([](Attempt& self, SystemError) {
    self.read();  // also after a failed write: the server may have sent a reason
  }));
}

/// A peer that does not trust the other disconnects, or TLS reports it.
void Attempt::on_ended() {
  const bool is_distrust = is_encrypted_ && !stream_->tls_fault().empty();
  fail(is_distrust ? NatsFault::kNotTrusted : NatsFault::kNoAnswer);
}

void Attempt::succeed() {
  NatsConnection connection{.stream = *std::move(stream_),
                            .is_encrypted = is_encrypted_,
                            .info = info_,
                            .server = without_secret(server()),
                            .received = std::move(received_)};
  stream_.reset();
  finish(std::move(connection));
}

void Attempt::fail(Error error) {
  if (error.code != ErrorCode::kUnavailable && !refusal_) refusal_ = std::move(error);
  try_next_server();
}

void Attempt::finish(Result<NatsConnection> result) {
  const auto callback = std::exchange(callback_, nullptr);
  cancel();
  callback(std::move(result));
}

void Attempt::close() {
  SystemError ignored;
  socket_.close(ignored);
  if (stream_) stream_->close();
}

}  // namespace

std::shared_ptr<NatsLoginAttempt> log_in_to_nats(asio::io_context& io, NatsOptions options,
                                                 NatsLoginCallback callback) {
  auto attempt = std::make_shared<Attempt>(io, std::move(options), std::move(callback));
  attempt->start();
  return attempt;
}

}  // namespace roomcast::hub::federation
