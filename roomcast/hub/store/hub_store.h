// SPDX-License-Identifier: Apache-2.0
// HubStore: what a hub keeps and what it signs. Rooms, sensors and tokens lie in one database; a
// token is good when this hub's secret signed it, its time has not passed, and nobody revoked it.
// Every change is on disk before it is acknowledged. Threading: one thread at a time; calls may
// wait for the disk.
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

  /// `folder`: holds hub.sqlite and hub.secret, both made where there are none; nothing: all is
  /// forgotten with the hub. Errors of Database::open and find_hub_secret.
  static Result<std::unique_ptr<HubStore>> open(const std::optional<std::filesystem::path>& folder,
                                                WallClock now = wall_time);

  SensorStore& sensors() { return sensors_; }
  RoomStore& rooms() { return rooms_; }

  /// Its settings, its sensors, and that its tokens hold: all or nothing, so that who comes to a
  /// new room of this name has a token for that one.
  [[nodiscard]] Status forget_room(const std::string& room);

  /// ERROR_TOKEN_INVALID, ERROR_TOKEN_EXPIRED, ERROR_TOKEN_REVOKED.
  [[nodiscard]] Verdict<Claims> check(const std::string& token);
  /// A code becomes a token. ERROR_CODE_USED, ERROR_TOKEN_EXPIRED, ERROR_TOKEN_REVOKED,
  /// ERROR_TOKEN_INVALID.
  [[nodiscard]] Verdict<NewToken> redeem(const std::string& code);

  /// kInvalidArgument: `ttl` is not 1 to kMaxTtl, or a grant that makes no sense.
  [[nodiscard]] Result<NewToken> issue(const Grant& grant, UnixSeconds ttl);
  [[nodiscard]] Result<NewCode> issue_code(const Grant& grant, UnixSeconds ttl);

  /// For helpers in the hub's own process: the whole hub's admin. Not listed, and good until the
  /// secret changes.
  [[nodiscard]] std::string sign_own() const;

  [[nodiscard]] Result<std::vector<IssuedToken>> tokens(std::string_view room) const {
    return tokens_.list(room);
  }
  [[nodiscard]] Result<IssuedToken> token(std::string_view id) const { return tokens_.find(id); }
  [[nodiscard]] Status revoke(std::string_view id) { return tokens_.revoke(id, now_()); }
  /// All tokens that have not expired.
  [[nodiscard]] Result<std::vector<Claims>> revoked() const { return tokens_.revoked(now_()); }
  /// Tokens that other hubs with the same secret have made, or this one, hold no more. Those that
  /// were not known as such.
  [[nodiscard]] Result<std::vector<Claims>> take_revoked(const std::vector<Claims>& tokens);
  /// Has another program, `roomcast token`, changed what is kept since this was last asked?
  [[nodiscard]] bool changed_elsewhere();

  [[nodiscard]] UnixSeconds now() const { return now_(); }

 private:
  HubStore(std::unique_ptr<Database> database, const HubSecret& secret, WallClock now);
  [[nodiscard]] Result<NewToken> sign(const Grant& grant, UnixSeconds ttl);

  std::unique_ptr<Database> database_;
  SensorStore sensors_{*database_};
  RoomStore rooms_{*database_};
  TokenStore tokens_{*database_};
  const TokenSigner signer_;
  const WallClock now_;
  std::int64_t foreign_changes_ = 0;
};

}  // namespace roomcast::hub
