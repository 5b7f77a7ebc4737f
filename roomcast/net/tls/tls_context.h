// SPDX-License-Identifier: Apache-2.0
// Settings shared by the TLS sessions of a server, or of a client. TLS 1.2 or later.
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
  /// kInvalidArgument if OpenSSL rejects the certificate (a weak key, for example).
  static Result<std::shared_ptr<const TlsServerContext>> create(const Certificate& certificate);
  [[nodiscard]] SSL_CTX* native() const { return context_.get(); }

 private:
  explicit TlsServerContext(std::shared_ptr<SSL_CTX> context) : context_(std::move(context)) {}
  std::shared_ptr<SSL_CTX> context_;
};

/// A client's criteria for accepting a server.
struct TlsTrust {
  std::string host;  // name or numeric address that the certificate must contain...
  std::optional<Fingerprint> pinned;  // ...unless it is exactly this certificate
};

/// PEM files of a client.
struct TlsClientFiles {
  std::string authorities_file = {};  // trusted authorities; empty: those of the system
  std::string certificate_file = {}, key_file = {};  // the client's own; empty: none
};

class TlsClientContext {
 public:
  /// kInvalidArgument: a file has the wrong content; the sentence names it. kUnavailable if OpenSSL
  /// cannot start.
  static Result<std::shared_ptr<const TlsClientContext>> create(const TlsClientFiles& files = {});
  [[nodiscard]] SSL_CTX* native() const { return context_.get(); }

 private:
  explicit TlsClientContext(std::shared_ptr<SSL_CTX> context) : context_(std::move(context)) {}
  std::shared_ptr<SSL_CTX> context_;
};

}  // namespace roomcast::net
