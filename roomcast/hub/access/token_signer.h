// SPDX-License-Identifier: Apache-2.0
// TokenSigner: makes join tokens and tells whether one is this hub's. A token is a compact JSON Web
// Token, HMAC-SHA256 with the hub's secret; no other algorithm is taken, whatever its header says.
// Threading: thread-safe (immutable). Source: RFC 7519 (JWT), RFC 8725 (what to refuse); by libjwt.
#pragma once

#include <string>

#include "roomcast/hub/access/claims.h"
#include "roomcast/hub/access/hub_secret.h"

namespace roomcast::hub {

class TokenSigner {
 public:
  explicit TokenSigner(const HubSecret& secret) : secret_(secret) {}

  [[nodiscard]] std::string sign(const Claims& claims) const;

  /// ERROR_TOKEN_INVALID: not made with this secret, or changed since. ERROR_TOKEN_EXPIRED.
  [[nodiscard]] Verdict<Claims> verify(const std::string& token, UnixSeconds now) const;

 private:
  HubSecret secret_;
};

}  // namespace roomcast::hub
