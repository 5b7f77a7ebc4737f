// SPDX-License-Identifier: Apache-2.0
// TlsSession: TLS on one connected, non-blocking socket. It never waits: each call does what is
// possible now and reports the condition to wait for. OpenSSL encrypts straight from the caller's
// memory to the socket. Threading: one thread at a time. Source: RFC 8446 (TLS 1.3), by OpenSSL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <openssl/types.h>

#include "roomcast/core/result.h"
#include "roomcast/net/tls/tls_context.h"

namespace roomcast::net {

class TlsSession {
 public:
  enum class Outcome {
    kDone,
    kWaitsToRead,   // call again when the socket is readable
    kWaitsToWrite,  // call again, with the same data, when the socket is writable
    kEnded,         // the peer has closed the session, or the socket has ended
    kFailed,        // see fault()
  };
  struct Step {
    Outcome outcome = Outcome::kFailed;
    std::size_t size = 0;  // bytes read or written
  };

  /// The caller owns the socket, which must outlive the session. kUnavailable: out of memory.
  static Result<TlsSession> accept(int fd, const TlsServerContext& context);
  static Result<TlsSession> connect(int fd, const TlsClientContext& context, TlsTrust trust);

  /// Also done by the first read() or write(). A client fails here if it does not trust the server.
  Step handshake();
  Step read(std::span<std::uint8_t> into);
  /// At most one record's worth, 16 KiB, at a time.
  Step write(std::span<const std::uint8_t> from);
  /// Sends the TLS close notification, if that is possible without waiting.
  void say_goodbye();

  /// The failure, as a sentence without its subject ("... has an untrusted
  /// certificate"); empty without a failure.
  [[nodiscard]] const std::string& fault() const { return fault_; }
  /// The peer has sent a plain HTTP request instead of TLS.
  [[nodiscard]] bool peer_speaks_plain_http() const { return plain_http_; }

 private:
  using Ssl = std::unique_ptr<SSL, void (*)(SSL*)>;

  TlsSession(Ssl ssl, TlsTrust trust) : ssl_(std::move(ssl)), trust_(std::move(trust)) {}
  static Result<TlsSession> create(int fd, SSL_CTX* context, TlsTrust trust);
  Step ready();
  Step outcome_of(int result);
  [[nodiscard]] bool is_trusted();
  void explain();

  Ssl ssl_;
  TlsTrust trust_;
  bool ready_ = false;  // the handshake is done and the peer is trusted
  bool failed_ = false;
  bool plain_http_ = false;
  std::string fault_;
};

}  // namespace roomcast::net
