// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/token_signer.h"

#include <gtest/gtest.h>
#include <jwt.h>

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

constexpr UnixSeconds kNow = 1'800'000'000;
const HubSecret kSecret = {1, 2, 3};

Claims for_a_viewer() {
  return {.id = "t1",
          .grant = {.room = "lab", .role = TokenRole::kViewer, .name = "Ada"},
          .issued_at = kNow,
          .expires_at = kNow + 60};
}

pb::ErrorCode token_fault(const std::string& token, UnixSeconds now = kNow) {
  const auto verdict = TokenSigner(kSecret).verify(token, now);
  const Refusal* why = refusal(verdict);
  return why == nullptr ? pb::ERROR_UNSPECIFIED : why->code;
}

/// A token forged with knowledge of the format but without the hub's secret.
std::string forged(jwt_alg_t algorithm, const std::string& secret) {
  jwt_t* token = nullptr;
  jwt_new(&token);
  jwt_add_grant(token, "jti", "t1");
  jwt_add_grant(token, "room", "lab");
  jwt_add_grant(token, "role", "admin");
  jwt_add_grant_int(token, "exp", kNow + 60);
  jwt_set_alg(token, algorithm, reinterpret_cast<const unsigned char*>(secret.data()),
              static_cast<int>(secret.size()));
  char* text = jwt_encode_str(token);
  std::string result = text;
  std::free(text);
  jwt_free(token);
  return result;
}

TEST(TokenSigner, reads_the_tokens_that_it_signed) {
  const TokenSigner signer(kSecret);
  const auto verdict = signer.verify(signer.sign(for_a_viewer()), kNow);
  const auto& claims = std::get<Claims>(verdict);
  EXPECT_EQ(claims.id, "t1");
  EXPECT_EQ(claims.grant.room, "lab");
  EXPECT_EQ(claims.grant.role, TokenRole::kViewer);
  EXPECT_EQ(claims.grant.name, "Ada");
  EXPECT_EQ(claims.expires_at, kNow + 60);
}

TEST(TokenSigner, a_token_is_valid_until_its_last_second) {
  const std::string token = TokenSigner(kSecret).sign(for_a_viewer());
  EXPECT_EQ(token_fault(token, kNow + 59), pb::ERROR_UNSPECIFIED);
  EXPECT_EQ(token_fault(token, kNow + 60), pb::ERROR_TOKEN_EXPIRED);
}

TEST(TokenSigner, detects_every_changed_letter) {
  const std::string token = TokenSigner(kSecret).sign(for_a_viewer());
  for (std::size_t i = 0; i < token.size(); ++i) {
    std::string changed = token;
    changed[i] = changed[i] == 'A' ? 'Q' : 'A';  // differ in an upper bit, which base64 keeps
    EXPECT_EQ(token_fault(changed), pb::ERROR_TOKEN_INVALID) << "letter " << i;
  }
}

TEST(TokenSigner, another_secrets_token_is_refused) {
  EXPECT_EQ(token_fault(TokenSigner(HubSecret{4, 5, 6}).sign(for_a_viewer())),
            pb::ERROR_TOKEN_INVALID);
}

TEST(TokenSigner, an_unsigned_token_is_refused) {
  EXPECT_EQ(token_fault(forged(JWT_ALG_NONE, "")), pb::ERROR_TOKEN_INVALID);
}

TEST(TokenSigner, another_algorithm_is_refused_even_with_the_right_secret) {
  const std::string secret(kSecret.begin(), kSecret.end());
  EXPECT_EQ(token_fault(forged(JWT_ALG_HS256, secret)), pb::ERROR_UNSPECIFIED);
  EXPECT_EQ(token_fault(forged(JWT_ALG_HS384, secret)), pb::ERROR_TOKEN_INVALID);
  EXPECT_EQ(token_fault(forged(JWT_ALG_HS512, secret)), pb::ERROR_TOKEN_INVALID);
}

TEST(TokenSigner, refuses_a_token_without_expiry) {
  Claims claims = for_a_viewer();
  claims.expires_at = 0;
  EXPECT_EQ(token_fault(TokenSigner(kSecret).sign(claims)), pb::ERROR_TOKEN_EXPIRED);
}

TEST(TokenSigner, refuses_invalid_tokens) {
  const std::vector<std::string> nonsense = {
      "", ".", "..", "a.b.c", "e30.e30.", std::string(9999, 'a'), std::string("\0\0\0", 3)};
  for (const auto& text : nonsense) EXPECT_EQ(token_fault(text), pb::ERROR_TOKEN_INVALID) << text;
}

}  // namespace
}  // namespace roomcast::hub
