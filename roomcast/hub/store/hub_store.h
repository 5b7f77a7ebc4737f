// SPDX-License-Identifier: Apache-2.0
// HubStore: a hub's persistent data and its token signing. Rooms, sensors and tokens are in one
// database. A token is valid if this hub's secret signed it, it has not expired, and it was not
// revoked. Every change is on disk before it is acknowledged. Threading: one thread at a time;
// calls may wait for the disk.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/access/claims.h"
#include "roomcast/hub/access/hub_secret.h"
#include "roomcast/hub/access/token_signer.h"
#include "roomcast/hub/access/wall_clock.h"
#include "roomcast/hub/store/mark_store.h"
#include "roomcast/hub/store/room_store.h"
#include "roomcast/hub/store/sensor_store.h"
#include "roomcast/hub/store/token_store.h"

namespace roomcast::hub {

struct NewToken {
  Claims claims;
  std::string token;
};

struct NewCode {
  std::string id, code;
  UnixSeconds expires_at = 0;
};

class HubStore {
 public:
  static constexpr UnixSeconds kMaxTtl = 10LL * 365 * 24 * 3600;
  static constexpr UnixSeconds kCodeTtl = 3600;

  /// `folder`: contains hub.sqlite and hub.secret, both created if missing; nothing: all data is
  /// lost when the hub ends. Errors of Database::open and find_hub_secret.
  static Result<std::unique_ptr<HubStore>> open(const std::optional<std::filesystem::path>& folder,
                                                WallClock now = wall_time);

  SensorStore& sensors() { return sensors_; }
  RoomStore& rooms() { return rooms_; }
  MarkStore& marks() { return marks_; }

  /// Deletes a room's settings, sensors and marks and revokes its tokens, all or nothing, so that
  /// old tokens do not admit to a new room of the same name.
  [[nodiscard]] Status forget_room(const std::string& room);

  /// ERROR_TOKEN_INVALID, ERROR_TOKEN_EXPIRED, ERROR_TOKEN_REVOKED.
  [[nodiscard]] Verdict<Claims> check(const std::string& token);
  /// Exchanges a code for a token. ERROR_CODE_USED, ERROR_TOKEN_EXPIRED, ERROR_TOKEN_REVOKED,
  /// ERROR_TOKEN_INVALID.
  [[nodiscard]] Verdict<NewToken> redeem(const std::string& code);

  /// kInvalidArgument: `ttl` is not 1 to kMaxTtl, or the grant is invalid.
  [[nodiscard]] Result<NewToken> issue(const Grant& grant, UnixSeconds ttl);
  [[nodiscard]] Result<NewCode> issue_code(const Grant& grant, UnixSeconds ttl);

  /// Signs an admin token for the whole hub, for helpers in the hub's process. It is not listed,
  /// and valid for kMaxTtl or until the secret changes.
  [[nodiscard]] std::string sign_own() const;

  [[nodiscard]] Result<std::vector<IssuedToken>> tokens(std::string_view room) const {
    return tokens_.list(room);
  }
  [[nodiscard]] Result<IssuedToken> token(std::string_view id) const { return tokens_.find(id); }
  [[nodiscard]] Status revoke(std::string_view id) { return tokens_.revoke(id, now_()); }
  /// All revoked tokens that have not expired.
  [[nodiscard]] Result<std::vector<Claims>> revoked() const { return tokens_.revoked(now_()); }
  /// Stores tokens as revoked that this hub or others with the same secret issued. Returns those
  /// that were not known to be revoked.
  [[nodiscard]] Result<std::vector<Claims>> add_revoked(const std::vector<Claims>& tokens);
  /// Whether another program (`roomcast token`) has changed the data since the last call.
  [[nodiscard]] bool changed_elsewhere();

  [[nodiscard]] UnixSeconds now() const { return now_(); }

 private:
  HubStore(std::unique_ptr<Database> database, const HubSecret& secret, WallClock now);
  [[nodiscard]] Result<NewToken> sign(const Grant& grant, UnixSeconds ttl);

  std::unique_ptr<Database> database_;
  SensorStore sensors_{*database_};
  RoomStore rooms_{*database_};
  MarkStore marks_{*database_};
  TokenStore tokens_{*database_};
  const TokenSigner signer_;
  const WallClock now_;
  std::int64_t foreign_changes_ = 0;
};

}  // namespace roomcast::hub
