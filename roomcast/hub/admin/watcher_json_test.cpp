// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/watcher_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/hub/admin/admin_api_fixture.h"

namespace roomcast::hub {
namespace {

nlohmann::json some_watcher() {
  return {{"key", std::string(32, 'a')}, {"name", "Ada"}, {"head", {1, 1.6, -2, 0, 0, 0, 1}}};
}

TEST(WatcherJson, is_read_as_it_was_said) {
  auto json = some_watcher();
  json["wants"] = {{"position_s", 2.5}, {"paused", true}, {"speed", 0.5}};
  json["viewer"] = 12;
  const auto read = read_watcher(json.dump());
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->name, "Ada");
  EXPECT_EQ(read->viewer, 12U);
  EXPECT_FLOAT_EQ(read->head[1], 1.6F);
  ASSERT_TRUE(read->wants.has_value());
  EXPECT_EQ(read->wants->position_s, 2.5);
  EXPECT_TRUE(read->wants->paused);
  EXPECT_FALSE(read_watcher(some_watcher().dump())->wants.has_value());
}

TEST(WatcherJson, that_is_something_else_is_refused) {
  const auto is_refused = [](const char* field, const nlohmann::json& value) {
    auto json = some_watcher();
    json[field] = value;
    return !read_watcher(json.dump()).ok();
  };
  EXPECT_TRUE(is_refused("key", "short"));
  EXPECT_TRUE(is_refused("name", "a\nb"));
  EXPECT_TRUE(is_refused("head", {1, 2, 3}));
  EXPECT_TRUE(is_refused("head", {1, 2, 3, 0, 0, 0, 2})) << "no rotation";
  EXPECT_TRUE(is_refused("head", {1e30, 2, 3, 0, 0, 0, 1}));
  EXPECT_TRUE(is_refused("wants", {{"position_s", -1}, {"paused", true}, {"speed", 1}}));
  EXPECT_TRUE(is_refused("wants", {{"position_s", 1}, {"paused", 1}, {"speed", 1}}));
  EXPECT_TRUE(is_refused("wants", {{"position_s", 1}, {"paused", true}, {"speed", 0}}));
  EXPECT_TRUE(is_refused("viewer", -1));
  EXPECT_TRUE(is_refused("viewer", 1e10));
  EXPECT_TRUE(is_refused("viewer", 1.5));
  EXPECT_TRUE(is_refused("more", 1));
  EXPECT_FALSE(read_watcher("").ok());
  EXPECT_FALSE(read_watcher("{}").ok());
}

class WatchTogetherTest : public AdminApiTest {};

TEST_F(WatchTogetherTest, admins_of_the_room_play_a_recording_together) {
  const std::string path = "/rooms/lab/recordings/one/together";
  auto ada = some_watcher(), bob = some_watcher();
  ada["wants"] = {{"position_s", 7}, {"paused", true}, {"speed", 1}};
  ada["viewer"] = 7;
  bob["key"] = std::string(32, 'b');
  EXPECT_EQ(ask("POST", path, hub_admin, ada).status, 200);
  const Answer seen = ask("POST", path, token("lab", TokenRole::kAdmin), bob);
  EXPECT_EQ(seen.body["people"][0]["name"], "Ada");
  EXPECT_EQ(seen.body["people"][0]["viewer"], 7);
  EXPECT_EQ(seen.body["playing"]["position_s"], 7);
  EXPECT_EQ(seen.body["change"], 1);
  EXPECT_EQ(ask("POST", path, token("lab", TokenRole::kViewer), bob).status, 403);
  EXPECT_EQ(ask("POST", path, hub_admin, {{"key", "?"}}).status, 400);
}

}  // namespace
}  // namespace roomcast::hub
