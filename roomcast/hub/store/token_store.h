// SPDX-License-Identifier: Apache-2.0
// TokenStore: the tokens that were issued, which of them were revoked, and the codes. Stores
// neither the tokens nor the codes themselves, so nobody can join with the data in the file.
// Threading: as Database.
#pragma once

#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/access/claims.h"
#include "roomcast/hub/access/one_time_code.h"
#include "roomcast/hub/store/database.h"

namespace roomcast::hub {

/// A token, or an unused code: then `claims` has the code's ID and times, and the grant of the
/// token for which it is exchanged.
struct IssuedToken {
  Claims claims;
  bool revoked = false;
  bool is_code = false;
};

/// The token for which a code is exchanged.
struct CodeGrant {
  Grant grant;
  UnixSeconds token_ttl = 0;
};

class TokenStore {
 public:
  static constexpr int kMaxListed = 1000;

  explicit TokenStore(Database& database) : database_(database) {}

  [[nodiscard]] Status add(const Claims& claims);
  /// Tokens and unused codes, newest first, at most kMaxListed: of one room, or of all if `room` is
  /// kAllRooms.
  [[nodiscard]] Result<std::vector<IssuedToken>> list(std::string_view room) const;
  /// kNotFound: this hub issued no such token, or it is a code that was used.
  [[nodiscard]] Result<IssuedToken> find(std::string_view id) const;
  [[nodiscard]] Result<bool> is_revoked(std::string_view id) const;
  /// Revokes a token or an unused code; idempotent. kNotFound: this hub issued none with this ID.
  [[nodiscard]] Status revoke(std::string_view id, UnixSeconds now);
  /// Revokes all tokens and codes for this room, also expired ones: this clock may be ahead.
  [[nodiscard]] Status revoke_all(std::string_view room, UnixSeconds now);
  /// Stores a token as revoked that another hub may have issued; idempotent.
  [[nodiscard]] Status add_revoked(const Claims& claims, UnixSeconds now);
  /// All revoked tokens that have not expired.
  [[nodiscard]] Result<std::vector<Claims>> revoked(UnixSeconds now) const;

  [[nodiscard]] Status add_code(const CodeDigest& digest, const CodeGrant& grant,
                                UnixSeconds issued_at, UnixSeconds expires_at);
  /// Redeems a code, for exactly one of several concurrent callers. ERROR_CODE_USED,
  /// ERROR_TOKEN_REVOKED, ERROR_TOKEN_EXPIRED, ERROR_TOKEN_INVALID (no such code);
  /// ERROR_UNSPECIFIED: the database does not respond.
  [[nodiscard]] Verdict<CodeGrant> redeem(const CodeDigest& digest, UnixSeconds now);

  /// Deletes tokens and codes that expired more than 30 days ago, except revoked tokens: when a
  /// clock that was ahead is set right, they would be valid again.
  [[nodiscard]] Status remove_expired(UnixSeconds now);

 private:
  [[nodiscard]] Refusal why_not_redeemed(const CodeDigest& digest) const;
  Database& database_;
};

}  // namespace roomcast::hub
