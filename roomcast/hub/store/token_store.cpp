// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/token_store.h"

namespace roomcast::hub {

namespace {

constexpr UnixSeconds kRemembered_s = 30 * 24 * 3600;  // after they expire
/// Tokens, and unused codes with the IDs of id_of_code().
constexpr char kIssued[] =
    "SELECT * FROM ("
    "  SELECT id, room, role, name, issued_at, expires_at, revoked_at, 0 AS is_code, rowid AS "
    "number"
    "    FROM tokens"
    "  UNION ALL"
    "  SELECT 'code-' || lower(hex(substr(digest, 1, 8))), room, role, name, issued_at, expires_at,"
    "    revoked_at, 1, rowid FROM codes WHERE used_at IS NULL) ";
constexpr char kRevoke[] = "UPDATE tokens SET revoked_at = coalesce(revoked_at, ?2) WHERE id = ?1";
constexpr char kRevokeCode[] =
    "UPDATE codes SET revoked_at = coalesce(revoked_at, ?2) WHERE used_at IS NULL AND ?1 = 'code-' "
    "|| lower(hex(substr(digest, 1, 8)))";
constexpr char kRedeem[] =
    "UPDATE codes SET used_at = ?2 WHERE digest = ?1 AND used_at IS NULL AND revoked_at IS NULL "
    "AND expires_at > ?2 RETURNING room, role, name, token_ttl_s";

IssuedToken read_token(const Statement& row) {
  IssuedToken token;
  token.claims.id = row.text(0);
  token.claims.grant = {.room = row.text(1),
                        .role = token_role(row.text(2)).value_or(TokenRole::kViewer),
                        .name = row.text(3)};
  token.claims.issued_at = row.integer(4);
  token.claims.expires_at = row.integer(5);
  token.revoked = !row.is_null(6);
  token.is_code = row.integer(7) != 0;
  return token;
}

Error no_such_token(std::string_view id) {
  return {ErrorCode::kNotFound, "this hub has issued no token \"" + std::string(id) + "\""};
}

}  // namespace

Status TokenStore::add(const Claims& claims) {
  Statement row(database_, "INSERT INTO tokens VALUES (?1, ?2, ?3, ?4, ?5, ?6, NULL)");
  row.bind(1, claims.id).bind(2, claims.grant.room).bind(3, name_of(claims.grant.role));
  row.bind(4, claims.grant.name).bind(5, claims.issued_at).bind(6, claims.expires_at);
  if (row.run()) return {};
  return database_.failure("cannot store a token");
}

Result<std::vector<IssuedToken>> TokenStore::list(std::string_view room) const {
  const std::string sql =
      std::string(kIssued) +
      "WHERE ?1 = '*' OR room = ?1 ORDER BY issued_at DESC, number DESC LIMIT ?2";
  Statement rows(database_, sql.c_str());
  rows.bind(1, room).bind(2, std::int64_t{kMaxListed});
  std::vector<IssuedToken> tokens;
  while (rows.next()) tokens.push_back(read_token(rows));
  if (!rows.finished()) return database_.failure("cannot read the tokens");
  return tokens;
}

Result<IssuedToken> TokenStore::find(std::string_view id) const {
  const std::string sql = std::string(kIssued) + "WHERE id = ?1";
  Statement row(database_, sql.c_str());
  row.bind(1, id);
  if (row.next()) return read_token(row);
  if (!row.finished()) return database_.failure("cannot look up a token");
  return no_such_token(id);
}

Result<bool> TokenStore::is_revoked(std::string_view id) const {
  Statement row(database_, "SELECT 1 FROM tokens WHERE id = ?1 AND revoked_at IS NOT NULL");
  row.bind(1, id);
  if (row.next()) return true;
  if (!row.finished()) return database_.failure("cannot look up a token");
  return false;
}

Status TokenStore::revoke(std::string_view id, UnixSeconds now) {
  for (const char* sql : {kRevoke, kRevokeCode}) {
    Statement row(database_, sql);
    if (!row.bind(1, id).bind(2, now).run()) return database_.failure("cannot revoke a token");
    if (database_.changed_rows() > 0) return {};
  }
  return no_such_token(id);
}

Status TokenStore::revoke_all(std::string_view room, UnixSeconds now) {
  for (const char* table : {"tokens", "codes"}) {
    const std::string sql = std::string("UPDATE ") + table +
                            " SET revoked_at = coalesce(revoked_at, ?2) WHERE room = ?1";
    Statement rows(database_, sql.c_str());
    if (!rows.bind(1, room).bind(2, now).run()) {
      return database_.failure("cannot revoke the tokens of a room");
    }
  }
  return {};
}

Status TokenStore::add_revoked(const Claims& claims, UnixSeconds now) {
  Statement row(database_,
                "INSERT INTO tokens VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7) ON CONFLICT (id) DO UPDATE "
                "SET revoked_at = coalesce(revoked_at, ?7)");
  row.bind(1, claims.id).bind(2, claims.grant.room).bind(3, name_of(claims.grant.role));
  row.bind(4, claims.grant.name).bind(5, claims.issued_at).bind(6, claims.expires_at);
  if (row.bind(7, now).run()) return {};
  return database_.failure("cannot store a revocation");
}

Result<std::vector<Claims>> TokenStore::revoked(UnixSeconds now) const {
  const std::string sql =
      std::string(kIssued) + "WHERE NOT is_code AND revoked_at IS NOT NULL AND expires_at > ?1";
  Statement rows(database_, sql.c_str());
  rows.bind(1, now);
  std::vector<Claims> tokens;
  while (rows.next()) tokens.push_back(read_token(rows).claims);
  if (!rows.finished()) return database_.failure("cannot read the tokens");
  return tokens;
}

Status TokenStore::add_code(const CodeDigest& digest, const CodeGrant& grant, UnixSeconds issued_at,
                            UnixSeconds expires_at) {
  Statement row(database_,
                "INSERT INTO codes (digest, room, role, name, token_ttl_s, expires_at, issued_at) "
                "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)");
  row.bind_blob(1, digest.data(), digest.size());
  row.bind(2, grant.grant.room).bind(3, name_of(grant.grant.role)).bind(4, grant.grant.name);
  if (row.bind(5, grant.token_ttl).bind(6, expires_at).bind(7, issued_at).run()) return {};
  return database_.failure("cannot store a code");
}

Verdict<CodeGrant> TokenStore::redeem(const CodeDigest& digest, UnixSeconds now) {
  Statement row(database_, kRedeem);
  row.bind_blob(1, digest.data(), digest.size()).bind(2, now);
  if (!row.next()) {
    if (row.finished()) return why_not_redeemed(digest);
    return Refusal{wire::pb::ERROR_UNSPECIFIED, "the hub cannot look up codes now; try again"};
  }
  CodeGrant grant{.grant = {.room = row.text(0),
                            .role = token_role(row.text(1)).value_or(TokenRole::kViewer),
                            .name = row.text(2)},
                  .token_ttl = row.integer(3)};
  if (!row.run()) {  // ends the statement and so commits that the code is used
    return Refusal{wire::pb::ERROR_UNSPECIFIED, "the hub cannot look up codes now; try again"};
  }
  return grant;
}

Refusal TokenStore::why_not_redeemed(const CodeDigest& digest) const {
  Statement row(database_, "SELECT used_at, revoked_at FROM codes WHERE digest = ?1");
  row.bind_blob(1, digest.data(), digest.size());
  if (!row.next()) return {wire::pb::ERROR_TOKEN_INVALID, "this hub has issued no such code"};
  if (!row.is_null(0)) {
    return {wire::pb::ERROR_CODE_USED, "this code was used already; ask for a new one"};
  }
  if (!row.is_null(1)) return {wire::pb::ERROR_TOKEN_REVOKED, "this code was revoked"};
  return {wire::pb::ERROR_TOKEN_EXPIRED, "this code has expired; ask for a new one"};
}

Status TokenStore::remove_expired(UnixSeconds now) {
  const UnixSeconds before = now - kRemembered_s;
  const char* forget = "DELETE FROM tokens WHERE expires_at < ?1 AND revoked_at IS NULL";
  if (Statement(database_, forget).bind(1, before).run() &&
      Statement(database_, "DELETE FROM codes WHERE expires_at < ?1").bind(1, before).run()) {
    return {};
  }
  return database_.failure("cannot forget old tokens");
}

}  // namespace roomcast::hub
