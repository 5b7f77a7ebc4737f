// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/admin_audit.h"

#include <map>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/hub/admin/admin_answer.h"

namespace roomcast::hub {
namespace {

using Fields = std::map<std::string, std::string, std::less<>>;

class AdminAuditTest : public testing::Test {
 protected:
  /// Sends the response through audited() and returns what arrives.
  net::HttpResponse answer(AuditedCall call, net::HttpResponse response) {
    std::optional<net::HttpResponse> answered;
    const net::Respond respond =
        audited(log, std::move(call), [&](net::HttpResponse r) { answered = std::move(r); });
    respond(std::move(response));
    return *answered;
  }

  std::vector<std::string> lines;
  Fields fields;
  LogSink log = [this](LogLevel, std::string_view line, LogFields about) {
    lines.emplace_back(line);
    fields.clear();
    for (const auto& [key, value] : about) fields.emplace(key, value);
  };
  const AuditedCall makes_token{.method = "POST",
                                .path = "/api/v1/tokens",
                                .peer = "10.0.0.7",
                                .token_id = "a1",
                                .name = "Ada"};
};

TEST_F(AdminAuditTest, logs_caller_and_action_without_secrets) {
  const auto sent = answer(makes_token, json_answer(201, {{"id", "b2"}, {"token", "sesame"}}));
  EXPECT_EQ(sent.status, 201);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0], "\"Ada\" (token a1) from 10.0.0.7: POST /api/v1/tokens: done, b2");
  const Fields expected{{"event", "admin"},   {"method", "POST"}, {"path", "/api/v1/tokens"},
                        {"peer", "10.0.0.7"}, {"token", "a1"},    {"name", "Ada"},
                        {"about", "b2"},      {"status", "201"},  {"error", ""}};
  EXPECT_EQ(fields, expected);
}

TEST_F(AdminAuditTest, logs_refusals_with_their_reason) {
  answer({.method = "GET", .path = "/api/v1/tokens", .peer = "10.0.0.7"},
         error_answer(401, "unauthenticated", "this takes an admin's token"));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0],
            "a caller without a valid token from 10.0.0.7: GET /api/v1/tokens is refused: this "
            "takes an admin's token");
  EXPECT_EQ(fields["error"], "unauthenticated");
}

TEST_F(AdminAuditTest, reads_are_not_logged) {
  answer({.method = "GET", .path = "/api/v1/rooms", .peer = "10.0.0.7"}, json_answer(200, {}));
  EXPECT_TRUE(lines.empty());
}

TEST_F(AdminAuditTest, works_without_a_log) {
  log = {};
  EXPECT_EQ(answer(makes_token, json_answer(201, {})).status, 201);
}

}  // namespace
}  // namespace roomcast::hub
