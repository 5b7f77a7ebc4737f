// SPDX-License-Identifier: Apache-2.0
// NatsCredentials: the credentials that a NATS operator issues to a user (.creds): a token (JWT)
// with the user's identity, and an Ed25519 private key to prove it by a signature. Threading:
// immutable. Source: docs.nats.io, "Decentralized JWT Authentication"; github.com/nats-io/nkeys
// (keys in base32, with a type prefix and a CRC-16); RFC 8032 (Ed25519), by OpenSSL.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "roomcast/core/result.h"

namespace roomcast::hub::federation {

class NatsCredentials {
 public:
  /// kNotFound: no such file. kMalformed: no user credentials in it, or damaged ones.
  static Result<NatsCredentials> load(const std::string& file);
  /// kMalformed, as above.
  static Result<NatsCredentials> parse(std::string_view text);

  [[nodiscard]] const std::string& user_jwt() const { return user_jwt_; }
  /// The signature of these bytes, in base64url without padding.
  [[nodiscard]] std::string sign(std::string_view text) const;

 private:
  using Seed = std::array<std::uint8_t, 32>;
  NatsCredentials(std::string_view user_jwt, const Seed& seed) : user_jwt_(user_jwt), seed_(seed) {}

  std::string user_jwt_;
  Seed seed_;
};

}  // namespace roomcast::hub::federation
