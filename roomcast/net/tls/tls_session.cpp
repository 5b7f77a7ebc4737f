// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/tls/tls_session.h"

#include <utility>

#include <boost/asio/ip/address.hpp>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>

#include "roomcast/core/assert.h"
#include "roomcast/net/tls/socket_bio.h"

namespace roomcast::net {

namespace {

bool is_numeric(const std::string& host) {
  boost::system::error_code not_numeric;
  boost::asio::ip::make_address(host, not_numeric);
  return !not_numeric;
}

/// Makes OpenSSL reject every certificate that is for another host or not signed by a trusted
/// authority.
bool demand_authority(SSL* ssl, const std::string& host) {
  SSL_set_verify(ssl, SSL_VERIFY_PEER, nullptr);
  if (is_numeric(host))
    return X509_VERIFY_PARAM_set1_ip_asc(SSL_get0_param(ssl), host.c_str()) == 1;
  return SSL_set1_host(ssl, host.c_str()) == 1 && SSL_set_tlsext_host_name(ssl, host.c_str()) == 1;
}

}  // namespace

Result<TlsSession> TlsSession::create(int fd, SSL_CTX* context, TlsTrust trust) {
  Ssl ssl(SSL_new(context), &SSL_free);
  BIO* bio = ssl == nullptr ? nullptr : make_socket_bio(fd);
  if (bio == nullptr) return Error{ErrorCode::kUnavailable, "no memory for a TLS session"};
  SSL_set_bio(ssl.get(), bio, bio);
  return TlsSession(std::move(ssl), std::move(trust));
}

Result<TlsSession> TlsSession::accept(int fd, const TlsServerContext& context) {
  auto session = create(fd, context.native(), {});
  if (session) SSL_set_accept_state(session->ssl_.get());
  return session;
}

Result<TlsSession> TlsSession::connect(int fd, const TlsClientContext& context, TlsTrust trust) {
  auto session = create(fd, context.native(), std::move(trust));
  if (!session) return session;
  SSL* ssl = session->ssl_.get();
  SSL_set_connect_state(ssl);
  const TlsTrust& whom = session->trust_;
  if (!whom.pinned && !demand_authority(ssl, whom.host)) {
    ERR_clear_error();
    return Error{ErrorCode::kInvalidArgument, "'" + whom.host + "' cannot be a host name"};
  }
  return session;
}

TlsSession::Step TlsSession::handshake() {
  if (failed_) return {Outcome::kFailed};
  ERR_clear_error();
  return ready();
}

TlsSession::Step TlsSession::read(std::span<std::uint8_t> into) {
  if (const Step step = handshake(); step.outcome != Outcome::kDone) return step;
  std::size_t size = 0;
  const int result = SSL_read_ex(ssl_.get(), into.data(), into.size(), &size);
  return result == 1 ? Step{Outcome::kDone, size} : outcome_of(result);
}

TlsSession::Step TlsSession::write(std::span<const std::uint8_t> from) {
  if (from.empty()) return {Outcome::kDone};
  if (const Step step = handshake(); step.outcome != Outcome::kDone) return step;
  std::size_t size = 0;
  const int result = SSL_write_ex(ssl_.get(), from.data(), from.size(), &size);
  return result == 1 ? Step{Outcome::kDone, size} : outcome_of(result);
}

void TlsSession::say_goodbye() {
  if (!ready_ || failed_) return;
  ERR_clear_error();
  SSL_shutdown(ssl_.get());
  ERR_clear_error();
}

TlsSession::Step TlsSession::ready() {
  if (ready_) return {Outcome::kDone};
  const int result = SSL_do_handshake(ssl_.get());
  if (result != 1) return outcome_of(result);
  ready_ = is_trusted();
  failed_ = !ready_;
  return {ready_ ? Outcome::kDone : Outcome::kFailed};
}

/// The handshake has verified the signature of an authority; a pinned fingerprint is compared here.
bool TlsSession::is_trusted() {
  if (!trust_.pinned) return true;
  const X509* certificate = SSL_get0_peer_certificate(ssl_.get());
  if (certificate != nullptr && fingerprint_of(certificate) == *trust_.pinned) return true;
  fault_ = "has a certificate with another fingerprint than the given one";
  if (certificate != nullptr) fault_ += " (sha256=" + to_string(fingerprint_of(certificate)) + ")";
  return false;
}

TlsSession::Step TlsSession::outcome_of(int result) {
  switch (SSL_get_error(ssl_.get(), result)) {
    case SSL_ERROR_WANT_READ:
      return {Outcome::kWaitsToRead};
    case SSL_ERROR_WANT_WRITE:
      return {Outcome::kWaitsToWrite};
    case SSL_ERROR_ZERO_RETURN:
      return {Outcome::kEnded};
    case SSL_ERROR_SYSCALL:
      failed_ = true;
      return {Outcome::kEnded};
    default:
      explain();
      return {ERR_GET_REASON(ERR_peek_error()) == SSL_R_UNEXPECTED_EOF_WHILE_READING
                  ? Outcome::kEnded
                  : Outcome::kFailed};
  }
}

void TlsSession::explain() {
  failed_ = true;
  const unsigned long error = ERR_peek_error();
  const int reason = ERR_GET_LIB(error) == ERR_LIB_SSL ? ERR_GET_REASON(error) : 0;
  const long verification = SSL_get_verify_result(ssl_.get());
  plain_http_ = reason == SSL_R_HTTP_REQUEST;
  if (reason == SSL_R_CERTIFICATE_VERIFY_FAILED && verification != X509_V_OK) {
    fault_ = std::string("has an untrusted certificate (") +
             X509_verify_cert_error_string(verification) + ")";
  } else if (reason == SSL_R_WRONG_VERSION_NUMBER) {
    fault_ = "does not speak TLS";
  } else {
    const char* text = ERR_reason_error_string(error);
    fault_ = std::string("and this program found no common TLS settings (") +
             (text == nullptr ? "unknown reason" : text) + ")";
  }
}

}  // namespace roomcast::net
