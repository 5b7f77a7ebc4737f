// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/hub_store.h"

#include "roomcast/wire/name_check.h"

namespace roomcast::hub {

namespace {

Status check_grant(const Grant& grant, UnixSeconds ttl) {
  if (ttl < 1 || ttl > HubStore::kMaxTtl)
    return invalid_argument("a token is valid from 1 second to ten years");
  if (grant.room.empty()) return invalid_argument("say which room the token is for");
  if (grant.room == kAllRooms && grant.role != TokenRole::kAdmin) {
    return invalid_argument("a token for a sensor or a viewer is for one room: say which");
  }
  if (auto s = wire::check_name(grant.room, "room"); !s) return invalid_argument(s.error().message);
  if (auto s = wire::check_name(grant.name, "token"); !s)
    return invalid_argument(s.error().message);
  return {};
}

}  // namespace

Result<std::unique_ptr<HubStore>> HubStore::open(const std::optional<std::filesystem::path>& folder,
                                                 WallClock now) {
  HubSecret secret = make_hub_secret();
  std::optional<std::filesystem::path> file;
  if (folder) {
    const auto found = find_hub_secret(secret_file_in(*folder));
    if (!found) return found.error();
    secret = *found;
    file = *folder / "hub.sqlite";
  }
  auto database = Database::open(file);
  if (!database) return database.error();
  return std::unique_ptr<HubStore>(new HubStore(*std::move(database), secret, std::move(now)));
}

HubStore::HubStore(std::unique_ptr<Database> database, const HubSecret& secret, WallClock now)
    : database_(std::move(database)), signer_(secret), now_(std::move(now)) {
  (void)tokens_.remove_expired(now_());  // an error does no harm: expired tokens are refused anyway
  foreign_changes_ = database_->foreign_changes();
}

Status HubStore::forget_room(const std::string& room) {
  return database_->in_transaction([&] {
    auto forgotten = rooms_.forget(room);
    if (forgotten) forgotten = sensors_.forget(room);
    if (forgotten) forgotten = marks_.forget(room);
    if (forgotten) forgotten = tokens_.revoke_all(room, now_());
    return forgotten;
  });
}

Verdict<Claims> HubStore::check(const std::string& token) {
  auto verdict = signer_.verify(token, now_());
  const Claims* claims = std::get_if<Claims>(&verdict);
  if (claims == nullptr) return verdict;
  const auto revoked = tokens_.is_revoked(claims->id);
  if (!revoked) {
    return Refusal{wire::pb::ERROR_UNSPECIFIED, "the hub cannot look up tokens now; try again"};
  }
  if (*revoked) return Refusal{wire::pb::ERROR_TOKEN_REVOKED, "this token was revoked"};
  return verdict;
}

Verdict<NewToken> HubStore::redeem(const std::string& code) {
  const auto digest = digest_of_code(code);
  if (!digest) return Refusal{wire::pb::ERROR_TOKEN_INVALID, "this is no valid code"};
  const auto redeemed = tokens_.redeem(*digest, now_());
  if (const Refusal* why = refusal(redeemed)) return *why;
  const auto& [grant, ttl] = std::get<CodeGrant>(redeemed);
  auto made = sign(grant, ttl);
  if (!made) return Refusal{wire::pb::ERROR_UNSPECIFIED, made.error().message};
  return *std::move(made);
}

Result<NewToken> HubStore::issue(const Grant& grant, UnixSeconds ttl) {
  if (auto status = check_grant(grant, ttl); !status) return status.error();
  return sign(grant, ttl);
}

Result<NewToken> HubStore::sign(const Grant& grant, UnixSeconds ttl) {
  const UnixSeconds now = now_();
  const Claims claims{
      .id = make_token_id(), .grant = grant, .issued_at = now, .expires_at = now + ttl};
  if (auto status = tokens_.add(claims); !status) return status.error();
  return NewToken{claims, signer_.sign(claims)};
}

Result<NewCode> HubStore::issue_code(const Grant& grant, UnixSeconds ttl) {
  if (auto status = check_grant(grant, ttl); !status) return status.error();
  const UnixSeconds now = now_();
  const std::string code = make_one_time_code();
  const CodeDigest digest = *digest_of_code(code);
  if (auto status = tokens_.add_code(digest, {grant, ttl}, now, now + kCodeTtl); !status) {
    return status.error();
  }
  return NewCode{id_of_code(digest), code, now + kCodeTtl};
}

std::string HubStore::sign_own() const {
  const UnixSeconds now = now_();
  return signer_.sign({.id = "own-" + make_token_id(),
                       .grant = {.room = std::string(kAllRooms), .role = TokenRole::kAdmin},
                       .issued_at = now,
                       .expires_at = now + kMaxTtl});
}

bool HubStore::changed_elsewhere() {
  const auto changes = database_->foreign_changes();
  return std::exchange(foreign_changes_, changes) != changes;
}

Result<std::vector<Claims>> HubStore::add_revoked(const std::vector<Claims>& tokens) {
  std::vector<Claims> news;
  for (const Claims& token : tokens) {
    if (token.expires_at <= now_() || token.expires_at > now_() + kMaxTtl) continue;
    const auto is_known = tokens_.is_revoked(token.id);
    if (!is_known) return is_known.error();
    if (*is_known) continue;
    if (auto status = tokens_.add_revoked(token, now_()); !status) return status.error();
    news.push_back(token);
  }
  return news;
}

}  // namespace roomcast::hub
