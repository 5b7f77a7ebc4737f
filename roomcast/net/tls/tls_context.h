// SPDX-License-Identifier: Apache-2.0
// What the TLS sessions of a server, or of a client, have in common. TLS 1.2 at least.
// Threading: immutable, share freely.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <openssl/types.h>

#include "roomcast/core/result.h"
#include "roomcast/net/tls/certificate.h"
#include "roomcast/net/tls/fingerprint.h"

namespace roomcast::net {

class TlsServerContext {
 public:
  /// kInvalidArgument when OpenSSL does not take the certificate (a weak key, say).
  static Result<std::shared_ptr<const TlsServerContext>> create(const Certificate& certificate);
  [[nodiscard]] SSL_CTX* native() const { return context_.get(); }

 private:
  explicit TlsServerContext(std::shared_ptr<SSL_CTX> context) : context_(std::move(context)) {}
  std::shared_ptr<SSL_CTX> context_;
};

/// Whom a client believes to be the server.
struct TlsTrust {
  std::string host;                   // name or numeric address, must be in the certificate...
  std::optional<Fingerprint> pinned;  // ...unless it is this very certificate
};

/// PEM files of a client.
struct TlsClientFiles {
  std::string authorities_file = {};                 // whom it trusts; empty: those of the system
  std::string certificate_file = {}, key_file = {};  // its own; empty: it shows none
};

class TlsClientContext {
 public:
  /// kInvalidArgument: a file holds something else; the sentence says which. kUnavailable when
  /// OpenSSL cannot start.
  static Result<std::shared_ptr<const TlsClientContext>> create(const TlsClientFiles& files = {});
  [[nodiscard]] SSL_CTX* native() const { return context_.get(); }

 private:
  explicit TlsClientContext(std::shared_ptr<SSL_CTX> context) : context_(std::move(context)) {}
  std::shared_ptr<SSL_CTX> context_;
};

}  // namespace roomcast::net
