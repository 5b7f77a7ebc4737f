// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/admin_answer.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using Json = nlohmann::json;

Json body_of(const net::HttpResponse& response) {
  return Json::parse(*response.body);
}

TEST(AdminAnswer, a_refusal_has_a_status_a_code_and_a_sentence) {
  const auto response = error_answer(Refusal{wire::pb::ERROR_TOKEN_REVOKED, "it was revoked"});
  EXPECT_EQ(response.status, 401);
  EXPECT_EQ(body_of(response)["error"]["code"], "revoked");
  EXPECT_EQ(body_of(response)["error"]["sentence"], "it was revoked");
  EXPECT_EQ(error_answer(Error{ErrorCode::kNotFound, ""}).status, 404);
  EXPECT_EQ(error_answer(Error{ErrorCode::kUnavailable, ""}).status, 503);
}

TEST(AdminAnswer, viewers_do_not_see_sending_rights_or_start_positions) {
  const Json brief = brief_room({.name = "lab", .title = "The lab"}, {});
  EXPECT_EQ(brief["title"], "The lab");
  EXPECT_FALSE(brief.contains("send"));
  EXPECT_FALSE(brief.contains("start_positions"));
  EXPECT_TRUE(whole_room({.name = "lab"}, {}).contains("send"));
}

TEST(AdminAnswer, a_sensor_has_only_known_fields) {
  SensorStats sensor{.id = SensorId{3}, .name = "left", .online = true, .frames = 9};
  sensor.clock_error_s = 0.002;
  const Json json = sensor_json(sensor, "192.0.2.7:5");
  EXPECT_EQ(json["clock_error_ms"], 2);
  EXPECT_EQ(json["address"], "192.0.2.7:5");
  EXPECT_EQ(json["world_from_depth"].size(), 16U);
  EXPECT_FALSE(json.contains("token_id"));
  EXPECT_FALSE(json.contains("interference"));
  sensor.interference = {
      .flickering = 0.02, .neighbour = "right", .shared = 0.4, .advice = "Turn it."};
  const Json disturbed = sensor_json(sensor, "")["interference"];
  EXPECT_EQ(disturbed["flickering"], 0.02);
  EXPECT_EQ(disturbed["neighbour"], "right");
  EXPECT_EQ(disturbed["advice"], "Turn it.");
  EXPECT_FALSE(sensor_json({.name = "off"}, "").contains("address"));
}

TEST(AdminAnswer, a_viewer_and_a_token_have_all_fields) {
  const Json viewer = viewer_json({.id = ViewerId{4}, .name = "Ada", .token_id = "t"}, "a");
  EXPECT_EQ(viewer["token_id"], "t");
  EXPECT_EQ(viewer["muted"], false);
  const Json token =
      token_json({.claims = {.id = "t", .grant = {.room = "lab", .role = TokenRole::kSensor}},
                  .revoked = true});
  EXPECT_EQ(token["role"], "sensor");
  EXPECT_EQ(token["revoked"], true);
  EXPECT_EQ(token["once"], false);
}

TEST(AdminAnswer, invalid_utf8_is_answered_as_valid_json) {
  EXPECT_EQ(json_answer(200, {{"name", "\xff"}}).status, 200);
}

}  // namespace
}  // namespace roomcast::hub
