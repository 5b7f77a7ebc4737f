// SPDX-License-Identifier: Apache-2.0
// TokenStore: the tokens that were made and which of them no longer hold, and the codes that wait
// to be exchanged. The tokens themselves are not kept, nor the codes: who reads the file cannot
// join with what it says. Threading: the database's.
#pragma once

#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/access/claims.h"
#include "roomcast/hub/access/one_time_code.h"
#include "roomcast/hub/store/database.h"

namespace roomcast::hub {

/// Or a code that nobody has used: `claims` are its own id and times, and the grant of the token
/// that it is exchanged for.
struct IssuedToken {
  Claims claims;
  bool revoked = false;
  bool is_code = false;
};

/// Of a code that has not been used: what it is exchanged for.
struct CodeGrant {
  Grant grant;
  UnixSeconds token_ttl = 0;
};

class TokenStore {
 public:
  static constexpr int kMaxListed = 1000;

  explicit TokenStore(Database& database) : database_(database) {}

  [[nodiscard]] Status add(const Claims& claims);
  /// Tokens and unused codes, newest first, at most kMaxListed; those of one room, or of all when
  /// `room` is kAllRooms.
  [[nodiscard]] Result<std::vector<IssuedToken>> list(std::string_view room) const;
  /// kNotFound: no such token was made here, or it is a code that was used.
  [[nodiscard]] Result<IssuedToken> find(std::string_view id) const;
  [[nodiscard]] Result<bool> is_revoked(std::string_view id) const;
  /// A token, or a code that nobody has used. kNotFound: no such was made here. Twice is as good as
  /// once.
  [[nodiscard]] Status revoke(std::string_view id, UnixSeconds now);
  /// All tokens and unused codes for this room.
  [[nodiscard]] Status revoke_all(std::string_view room, UnixSeconds now);
  /// One that was perhaps made elsewhere. Twice is as good as once.
  [[nodiscard]] Status add_revoked(const Claims& claims, UnixSeconds now);
  /// All tokens that have not expired.
  [[nodiscard]] Result<std::vector<Claims>> revoked(UnixSeconds now) const;

  [[nodiscard]] Status add_code(const CodeDigest& digest, const CodeGrant& grant,
                                UnixSeconds issued_at, UnixSeconds expires_at);
  /// For exactly one caller, however many try. ERROR_CODE_USED, ERROR_TOKEN_REVOKED,
  /// ERROR_TOKEN_EXPIRED, ERROR_TOKEN_INVALID (there was no such code); ERROR_UNSPECIFIED: the
  /// database does not answer.
  [[nodiscard]] Verdict<CodeGrant> redeem(const CodeDigest& digest, UnixSeconds now);

  /// Forgets what expired long ago.
  [[nodiscard]] Status tidy(UnixSeconds now);

 private:
  [[nodiscard]] Refusal why_not_redeemed(const CodeDigest& digest) const;
  Database& database_;
};

}  // namespace roomcast::hub
