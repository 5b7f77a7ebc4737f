// SPDX-License-Identifier: Apache-2.0
// TokenSigner: signs and verifies join tokens. A token is a compact JSON Web Token with HMAC-SHA256
// and the hub's secret; other algorithms are refused, whatever the token's header states.
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

  /// ERROR_TOKEN_INVALID: not signed with this secret, or modified. ERROR_TOKEN_EXPIRED.
  [[nodiscard]] Verdict<Claims> verify(const std::string& token, UnixSeconds now) const;

 private:
  HubSecret secret_;
};

}  // namespace roomcast::hub
