// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/sensor_settings_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::hub {
namespace {

TEST(SensorSettingsJson, a_request_says_what_changes) {
  const auto request = read_settings_request(R"({"codec": "lossless", "mbit": 0, "fps": 10})");
  ASSERT_TRUE(request.ok()) << request.error().message;
  EXPECT_EQ(request->settings().codec(), "lossless");
  EXPECT_TRUE(request->settings().has_mbit());
  EXPECT_FALSE(request->restart());
  EXPECT_EQ(described(*request), "codec lossless, no target rate, 10 frames/s");
  EXPECT_EQ(described(*read_settings_request(R"({"mbit": "auto", "restart": true})")),
            "as many Mbit/s as the line carries, restart");
  EXPECT_EQ(described(*read_settings_request(R"({"mbit": 2.5})")), "2.5 Mbit/s");
}

TEST(SensorSettingsJson, anything_else_is_refused_with_a_sentence) {
  for (const char* body :
       {"", "[]", "{}", R"({"codec": 1})", R"({"mbit": "much"})", R"({"mbit": -1})",
        R"({"fps": 1000})", R"({"fps": true})", R"({"restart": 1})", R"({"colour": "red"})"})
    EXPECT_FALSE(read_settings_request(body).ok()) << body;
}

TEST(SensorSettingsJson, settings_are_told_as_they_are_asked_for) {
  wire::pb::SensorSettings settings;
  settings.set_codec("live");
  settings.set_mbit(2);
  EXPECT_EQ(to_json(settings), nlohmann::json({{"codec", "live"}, {"mbit", 2.0}}));
  settings.set_fits_line(true);
  settings.set_fps(15);
  EXPECT_EQ(to_json(settings),
            nlohmann::json({{"codec", "live"}, {"mbit", "auto"}, {"fps", 15.0}}));
}

}  // namespace
}  // namespace roomcast::hub
