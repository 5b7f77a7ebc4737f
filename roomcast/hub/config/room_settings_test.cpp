// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/config/room_settings.h"

#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::hub {
namespace {

using Json = nlohmann::json;

std::string settings_fault(const Json& changes) {
  const auto result = changed({}, changes);
  return result ? "" : result.error().message;
}

TEST(RoomSettings, survive_conversion_to_json) {
  const RoomSettings settings{.name = "lab",
                              .title = "The lab",
                              .max_sensors = 4,
                              .max_viewers = 20,
                              .listed = false,
                              .send = AccessRule::kToken,
                              .view = AccessRule::kAdmin,
                              .record = AccessRule::kNobody,
                              .share = AccessRule::kToken,
                              .speak = AccessRule::kAdmin,
                              .record_voices = false,
                              .stream_unwatched = true,
                              .start_positions = {{.x_m = 1, .z_m = -2, .eye_height_m = 1.7}},
                              .embed_from = {"https://example.org"}};
  const auto read = changed({}, to_json(settings));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(to_json(*read), to_json(settings));
}

TEST(RoomSettings, unnamed_fields_stay) {
  RoomSettings settings;
  settings.max_viewers = 7;
  const auto result = changed(settings, {{"title", "Kitchen"}});
  EXPECT_EQ(result->max_viewers, 7U);
  EXPECT_EQ(result->title, "Kitchen");
}

TEST(RoomSettings, a_wrong_field_or_value_is_named) {
  EXPECT_NE(settings_fault({{"colour", "red"}}).find("colour"), std::string::npos);
  EXPECT_NE(settings_fault({{"view", "friends"}}).find("view"), std::string::npos);
  EXPECT_NE(settings_fault({{"max_viewers", -1}}).find("max_viewers"), std::string::npos);
  EXPECT_NE(settings_fault({{"max_viewers", 100'000}}).find("max_viewers"), std::string::npos);
  EXPECT_NE(settings_fault({{"max_sensors", 0}}).find("max_sensors"), std::string::npos);
  EXPECT_NE(settings_fault({{"start_positions", {{{"x", 1}}}}}).find("start_positions"),
            std::string::npos);
  EXPECT_NE(settings_fault({{"start_positions", {{{"x", 1e300}, {"z", 0}}}}}), "");
  EXPECT_NE(settings_fault({{"listed", 1}}), "");
  EXPECT_NE(settings_fault({{"record_voices", "nobody"}}), "");
  EXPECT_NE(settings_fault({{"stream_unwatched", "yes"}}), "");
  EXPECT_NE(settings_fault(Json::array()), "");
}

TEST(RoomSettings, sites_that_may_show_the_room_are_written_as_browsers_do) {
  const auto settings =
      changed({}, {{"embed_from", {"https://Example.org:443", "https://example.org"}}});
  ASSERT_TRUE(settings.ok()) << settings.error().message;
  EXPECT_EQ(settings->embed_from, std::vector<std::string>{"https://example.org"});
  EXPECT_TRUE(changed(*settings, {{"embed_from", Json::array()}})->embed_from.empty());
}

TEST(RoomSettings, what_is_no_site_may_not_show_the_room) {
  EXPECT_NE(settings_fault({{"embed_from", {"*"}}}).find("\"*\" is no web site"),
            std::string::npos);
  EXPECT_NE(settings_fault({{"embed_from", {"https://a.org/; x"}}}).find("without a path"),
            std::string::npos);
  EXPECT_NE(settings_fault({{"embed_from", "https://a.org"}}), "");
  EXPECT_NE(settings_fault({{"embed_from", {1}}}), "");
  Json many = Json::array();
  for (int i = 0; i <= 16; ++i) many.push_back("https://a" + std::to_string(i) + ".org");
  EXPECT_NE(settings_fault({{"embed_from", many}}).find("16 web sites at most"), std::string::npos);
}

TEST(RoomSettings, a_room_needs_a_valid_name) {
  EXPECT_NE(settings_fault({{"name", ""}}), "");
  EXPECT_NE(settings_fault({{"name", "*"}}), "") << "it would be all rooms in a token";
  EXPECT_NE(settings_fault({{"name", std::string(65, 'x')}}), "");
  EXPECT_NE(settings_fault({{"name", "a\nb"}}), "");
}

TEST(RoomSettings, a_start_position_has_its_heading) {
  const RigidTransform ahead = world_from_viewer({.x_m = 1, .z_m = 2});
  EXPECT_EQ(ahead.translation_m, Eigen::Vector3d(1, 1.6, 2));
  EXPECT_EQ(ahead.rotation.col(2).z(), 1) << "-z of the viewer is -z of the world";
  const RigidTransform left = world_from_viewer({.yaw_rad = std::numbers::pi / 2});
  EXPECT_NEAR(-left.rotation.col(2).x(), -1, 1e-12)
      << "a quarter turn counter-clockwise looks along -x";
}

TEST(RoomSettings, an_uplink_is_a_tenth_to_a_thousand_or_none) {
  for (const double mbit : {0.0, 0.1, 8.0, 1000.0}) {
    const auto set = changed(RoomSettings(), {{"uplink_mbit", mbit}});
    ASSERT_TRUE(set.ok()) << mbit;
    EXPECT_EQ(set->uplink_mbit, mbit);
    EXPECT_EQ(to_json(*set)["uplink_mbit"], mbit);
  }
  for (const double mbit : {-1.0, 0.05, 1001.0})
    EXPECT_FALSE(changed(RoomSettings(), {{"uplink_mbit", mbit}}).ok()) << mbit;
  EXPECT_FALSE(changed(RoomSettings(), {{"uplink_mbit", "fast"}}).ok());
}

}  // namespace
}  // namespace roomcast::hub
