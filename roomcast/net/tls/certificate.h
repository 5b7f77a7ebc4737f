// SPDX-License-Identifier: Apache-2.0
// A server's certificate and private key, read from PEM files or self-signed. Source: RFC 5280
// (certificates), RFC 6125 (names in them); created and parsed by OpenSSL.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <openssl/types.h>

#include "roomcast/core/result.h"
#include "roomcast/net/tls/fingerprint.h"

namespace roomcast::net {

class Certificate {
 public:
  /// `certificate` is a PEM file with the server's certificate followed by its signers'
  /// certificates; `key` contains the private key without a passphrase. kNotFound: no such file;
  /// kMalformed: not PEM, or the key does not match the certificate.
  static Result<Certificate> load(const std::filesystem::path& certificate,
                                  const std::filesystem::path& key);

  /// A new self-signed P-256 certificate, valid for ten years, for these host names and numeric
  /// addresses (at least one).
  static Result<Certificate> make_self_signed(const std::vector<std::string>& hosts);

  /// Saves both in one PEM file readable by its owner only. kUnavailable if it cannot be written.
  [[nodiscard]] Status save(const std::filesystem::path& file) const;

  [[nodiscard]] Fingerprint fingerprint() const;
  [[nodiscard]] X509* leaf() const { return chain_.front().get(); }
  /// The leaf first.
  [[nodiscard]] const std::vector<std::shared_ptr<X509>>& chain() const { return chain_; }
  [[nodiscard]] EVP_PKEY* key() const { return key_.get(); }

 private:
  Certificate(std::vector<std::shared_ptr<X509>> chain, std::shared_ptr<EVP_PKEY> key)
      : chain_(std::move(chain)), key_(std::move(key)) {}

  std::vector<std::shared_ptr<X509>> chain_;  // never empty
  std::shared_ptr<EVP_PKEY> key_;
};

/// SHA-256 of a certificate.
[[nodiscard]] Fingerprint fingerprint_of(const X509* certificate);

}  // namespace roomcast::net
