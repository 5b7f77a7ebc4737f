// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/tls/tls_context.h"

#include <utility>

#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509_vfy.h>

#include "roomcast/net/tls/pem_file.h"

namespace roomcast::net {

namespace {

std::shared_ptr<SSL_CTX> make_context(const SSL_METHOD* method) {
  std::shared_ptr<SSL_CTX> context(SSL_CTX_new(method), &SSL_CTX_free);
  if (context == nullptr) return nullptr;
  SSL_CTX_set_min_proto_version(context.get(), TLS1_2_VERSION);
  SSL_CTX_set_options(context.get(), SSL_OP_NO_RENEGOTIATION | SSL_OP_NO_COMPRESSION);
  // Moving buffer: data may be at another address when a write is retried. Released buffers: an
  // idle viewer then costs 34 KB less.
  SSL_CTX_set_mode(context.get(), SSL_MODE_ENABLE_PARTIAL_WRITE |
                                      SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER |
                                      SSL_MODE_RELEASE_BUFFERS);
  return context;
}

/// The newest error reason of OpenSSL, as the end of a sentence.
std::string take_reason() {
  const char* reason = ERR_reason_error_string(ERR_peek_last_error());
  ERR_clear_error();
  return reason == nullptr ? "unknown reason" : reason;
}

/// Trusts only the authorities in `file`; empty: those of the system.
Status trust_authorities(SSL_CTX* context, const std::string& file) {
  if (file.empty()) return {};
  const auto issuers = read_certificates(file);
  if (!issuers) {
    return Error{ErrorCode::kInvalidArgument,
                 "no issuers' certificates are to be had: " + issuers.error().message};
  }
  SSL_CTX_set_cert_store(context, X509_STORE_new());
  for (const auto& issuer : *issuers)
    X509_STORE_add_cert(SSL_CTX_get_cert_store(context), issuer.get());
  ERR_clear_error();
  return {};
}

/// Sets the certificate with its key and its signers' certificates.
Status show_certificate(SSL_CTX* context, const Certificate& certificate) {
  bool good = SSL_CTX_use_certificate(context, certificate.leaf()) == 1 &&
              SSL_CTX_use_PrivateKey(context, certificate.key()) == 1;
  for (std::size_t i = 1; good && i < certificate.chain().size(); ++i) {
    good = SSL_CTX_add1_chain_cert(context, certificate.chain()[i].get()) == 1;
  }
  if (good) return {};
  return Error{ErrorCode::kInvalidArgument,
               "the certificate cannot be used for TLS: " + take_reason()};
}

Status show_own_certificate(SSL_CTX* context, const TlsClientFiles& files) {
  if (files.certificate_file.empty()) return {};
  const auto certificate = Certificate::load(files.certificate_file, files.key_file);
  if (!certificate) return Error{ErrorCode::kInvalidArgument, certificate.error().message};
  return show_certificate(context, *certificate);
}

}  // namespace

Result<std::shared_ptr<const TlsServerContext>> TlsServerContext::create(
    const Certificate& certificate) {
  auto context = make_context(TLS_server_method());
  if (context == nullptr) {
    return Error{ErrorCode::kInvalidArgument, "TLS cannot be started: " + take_reason()};
  }
  if (auto status = show_certificate(context.get(), certificate); !status) return status.error();
  // Sessions are not resumed: a room is joined once, and tickets would weaken forward secrecy.
  SSL_CTX_set_session_cache_mode(context.get(), SSL_SESS_CACHE_OFF);
  SSL_CTX_set_num_tickets(context.get(), 0);
  return std::shared_ptr<const TlsServerContext>(new TlsServerContext(std::move(context)));
}

Result<std::shared_ptr<const TlsClientContext>> TlsClientContext::create(
    const TlsClientFiles& files) {
  auto context = make_context(TLS_client_method());
  if (context == nullptr || SSL_CTX_set_default_verify_paths(context.get()) != 1) {
    return Error{ErrorCode::kUnavailable, "TLS cannot be started: " + take_reason()};
  }
  if (auto status = trust_authorities(context.get(), files.authorities_file); !status) {
    return status.error();
  }
  if (auto status = show_own_certificate(context.get(), files); !status) return status.error();
  return std::shared_ptr<const TlsClientContext>(new TlsClientContext(std::move(context)));
}

}  // namespace roomcast::net
