// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/token_signer.h"

#include <cstdlib>
#include <memory>
#include <optional>

#include <jwt.h>

#include "roomcast/core/assert.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

namespace {

using Token = std::unique_ptr<jwt_t, decltype(&jwt_free)>;

std::string grant_text(jwt_t* token, const char* key) {
  const char* text = jwt_get_grant(token, key);
  return text == nullptr ? "" : text;
}

std::optional<Claims> read_claims(jwt_t* token) {
  const auto role = token_role(grant_text(token, "role"));
  Claims claims{.id = grant_text(token, "jti"),
                .grant = {.room = grant_text(token, "room"), .name = grant_text(token, "sub")},
                .issued_at = jwt_get_grant_int(token, "iat"),
                .expires_at = jwt_get_grant_int(token, "exp")};
  if (!role || claims.id.empty() || claims.grant.room.empty()) return std::nullopt;
  claims.grant.role = *role;
  return claims;
}

Refusal invalid() {
  return {wire::pb::ERROR_TOKEN_INVALID,
          "this hub has not issued this token, or it was changed since; ask for a new one"};
}

}  // namespace

std::string TokenSigner::sign(const Claims& claims) const {
  jwt_t* made = nullptr;
  const bool started = jwt_new(&made) == 0;
  const Token token(made, &jwt_free);
  const bool complete =
      started && jwt_add_grant(made, "jti", claims.id.c_str()) == 0 &&
      jwt_add_grant(made, "room", claims.grant.room.c_str()) == 0 &&
      jwt_add_grant(made, "role", std::string(name_of(claims.grant.role)).c_str()) == 0 &&
      (claims.grant.name.empty() || jwt_add_grant(made, "sub", claims.grant.name.c_str()) == 0) &&
      jwt_add_grant_int(made, "iat", claims.issued_at) == 0 &&
      jwt_add_grant_int(made, "exp", claims.expires_at) == 0 &&
      jwt_set_alg(made, JWT_ALG_HS256, secret_.data(), static_cast<int>(secret_.size())) == 0;
  ROOMCAST_ASSERT(complete);
  const std::unique_ptr<char, decltype(&std::free)> text(jwt_encode_str(made), &std::free);
  ROOMCAST_ASSERT(text != nullptr);
  return text.get();
}

Verdict<Claims> TokenSigner::verify(const std::string& text, UnixSeconds now) const {
  if (text.size() > wire::kMaxTokenBytes) return invalid();
  jwt_t* decoded = nullptr;
  const int fault =
      jwt_decode(&decoded, text.c_str(), secret_.data(), static_cast<int>(secret_.size()));
  const Token token(decoded, &jwt_free);
  if (fault != 0 || jwt_get_alg(decoded) != JWT_ALG_HS256) return invalid();
  auto claims = read_claims(decoded);
  if (!claims) return invalid();
  if (claims->expires_at <= now) {
    return Refusal{wire::pb::ERROR_TOKEN_EXPIRED, "this token has expired; ask for a new one"};
  }
  return *std::move(claims);
}

}  // namespace roomcast::hub
