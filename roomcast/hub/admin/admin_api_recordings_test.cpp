// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/hub/admin/admin_api_fixture.h"

namespace roomcast::hub {
namespace {

using testing::Contains;
using testing::Pair;

class AdminApiRecordingsTest : public AdminApiTest {
 protected:
  AdminApiRecordingsTest() {
    recordings.files.files = {
        {.name = "one", .room = "lab", .by = "Ada", .problem = "", .bytes = 7, .seconds = 2.5},
        {.name = "busy", .room = "lab", .by = "", .state = KeptState::kRunning, .problem = ""},
        {.name = "lost", .room = "", .by = "", .state = KeptState::kUnreadable, .problem = "Bad."},
        {.name = "other", .room = "cellar", .by = "", .problem = ""}};
  }
  std::vector<std::string> names(const std::string& token) {
    std::vector<std::string> names;
    const Answer list = ask("GET", "/rooms/lab/recordings", token);
    for (const auto& file : list.body["recordings"]) names.push_back(file["name"]);
    return names;
  }
};

TEST_F(AdminApiRecordingsTest, lists_those_of_the_room_and_unknown_ones_to_admins_of_the_hub) {
  const Answer list = ask("GET", "/rooms/lab/recordings", hub_admin);
  EXPECT_EQ(list.status, 200);
  EXPECT_EQ(list.body["left_out"], 3);
  EXPECT_EQ(list.body["unread"], 1);
  EXPECT_EQ(list.body["recordings"][0]["by"], "Ada");
  EXPECT_EQ(list.body["recordings"][0]["state"], "whole");
  EXPECT_EQ(list.body["recordings"][2]["problem"], "Bad.");
  EXPECT_THAT(names(hub_admin), testing::ElementsAre("one", "busy", "lost"));
  EXPECT_THAT(names(token("lab", TokenRole::kAdmin)), testing::ElementsAre("one", "busy"));
}

TEST_F(AdminApiRecordingsTest, are_for_the_admins_of_their_room_only) {
  for (const auto& [method, path] :
       std::vector<std::pair<std::string, std::string>>{{"GET", ""},
                                                        {"PATCH", "/one"},
                                                        {"DELETE", "/one"},
                                                        {"GET", "/one/file"},
                                                        {"POST", "/one/download"},
                                                        {"GET", "/one"},
                                                        {"GET", "/one/moments/0"},
                                                        {"GET", "/one/parts/0"},
                                                        {"GET", "/one/sensors/s0/key-frames/0"}}) {
    const std::string address = "/rooms/lab/recordings" + path;
    EXPECT_EQ(ask(method, address).code(), "unauthenticated") << method << path;
    EXPECT_EQ(ask(method, address, token("lab", TokenRole::kViewer)).code(), "wrong_role");
    EXPECT_EQ(ask(method, address, token("cellar", TokenRole::kAdmin)).code(), "wrong_role");
  }
  EXPECT_EQ(ask("DELETE", "/rooms/lab/recordings/other", hub_admin).code(), "not_found");
  EXPECT_EQ(recordings.files.files.size(), 4u);
}

TEST_F(AdminApiRecordingsTest, are_renamed_and_deleted) {
  EXPECT_EQ(ask("PATCH", "/rooms/lab/recordings/one", hub_admin, {{"name", "a b"}}).body["name"],
            "a b");
  EXPECT_EQ(ask("DELETE", "/rooms/lab/recordings/a%20b", hub_admin).status, 204);
  EXPECT_EQ(ask("DELETE", "/rooms/lab/recordings/a%20b", hub_admin).code(), "not_found");
  EXPECT_EQ(ask("DELETE", "/rooms/lab/recordings/busy", hub_admin).code(), "conflict");
  EXPECT_EQ(ask("PATCH", "/rooms/lab/recordings/lost", hub_admin, {{"name", 1}}).code(),
            "bad_request");
  EXPECT_EQ(ask("PATCH", "/rooms/lab/recordings/lost", hub_admin).code(), "bad_request");
}

TEST_F(AdminApiRecordingsTest, are_played_part_by_part) {
  const auto body = [&](const std::string& path) {
    return *ask("GET", "/rooms/lab/recordings" + path, hub_admin).response.body;
  };
  EXPECT_EQ(ask("GET", "/rooms/lab/recordings/one", hub_admin).body["seconds"], 2.5);
  EXPECT_EQ(body("/one/moments/1500"), "moment 1500");
  EXPECT_EQ(body("/one/parts/7"), "part 7");
  EXPECT_EQ(body("/one/sensors/left%20/key-frames/250"), "key frame left 250");
  EXPECT_EQ(ask("GET", "/rooms/lab/recordings/one/sensors/s0/key-frames/x", hub_admin).code(),
            "bad_request");
  for (const char* bad : {"-1", "1.5", "x", "99999999999", "1%20"}) {
    const std::string path = std::string("/rooms/lab/recordings/one/parts/") + bad;
    EXPECT_EQ(ask("GET", path, hub_admin).code(), "bad_request") << bad;
  }
  EXPECT_EQ(ask("GET", "/rooms/lab/recordings/none/parts/0", hub_admin).code(), "not_found");
  EXPECT_EQ(ask("GET", "/rooms/lab/recordings/busy/moments/0", hub_admin).code(), "conflict");
}

TEST_F(AdminApiRecordingsTest, are_fetched_with_a_token_or_once_by_a_link) {
  const Answer file = ask("GET", "/rooms/lab/recordings/one/file", hub_admin);
  EXPECT_EQ(file.status, 200);
  EXPECT_EQ(file.response.long_body->size(), 7u);
  EXPECT_THAT(file.response.headers,
              Contains(Pair("Content-Disposition", "attachment; filename*=UTF-8''one.mcap")));
  const Answer made = ask("POST", "/rooms/lab/recordings/one/download", hub_admin);
  EXPECT_EQ(made.status, 201);
  EXPECT_EQ(made.body["bytes"], 7);
  const std::string address = "/" + std::string(made.body["address"]);
  EXPECT_EQ(ask("GET", address).response.long_body->size(), 7u);
  EXPECT_EQ(ask("GET", address).code(), "not_found");
  EXPECT_EQ(ask("POST", "/rooms/lab/recordings/none/download", hub_admin).code(), "not_found");
}

TEST_F(AdminApiRecordingsTest, a_room_is_recorded_from_start_to_stop) {
  EXPECT_EQ(ask("GET", "/rooms/lab/recording", hub_admin).body["state"], "off");
  EXPECT_EQ(ask("DELETE", "/rooms/lab/recording", hub_admin).code(), "conflict");
  const std::string ada = "Ada";
  const Answer token =
      ask("POST", "/tokens", hub_admin, {{"room", "lab"}, {"role", "admin"}, {"name", ada}});
  const Answer started = ask("POST", "/rooms/lab/recording", token.body["token"]);
  EXPECT_EQ(started.status, 201);
  EXPECT_EQ(started.body["state"], "on");
  EXPECT_EQ(started.body["file"], "lab.mcap");
  EXPECT_EQ(recordings.started_by, ada);
  EXPECT_EQ(ask("POST", "/rooms/lab/recording", hub_admin).code(), "conflict");
  EXPECT_EQ(ask("DELETE", "/rooms/lab/recording", hub_admin).body["state"], "off");
}

TEST_F(AdminApiRecordingsTest, an_unrecordable_room_is_not_recorded) {
  ask("PATCH", "/rooms/lab", hub_admin, {{"record", "nobody"}});
  EXPECT_EQ(ask("POST", "/rooms/lab/recording", hub_admin).code(), "wrong_role");
  EXPECT_TRUE(recordings.rooms.empty());
}

TEST_F(AdminApiRecordingsTest, a_hub_without_recorder_refuses_to_record) {
  AdminApi without{registry, store_worker, "test", nullptr};
  asked = &without;
  EXPECT_EQ(ask("GET", "/rooms/lab/recording", hub_admin).body["state"], "off");
  EXPECT_EQ(ask("POST", "/rooms/lab/recording", hub_admin).code(), "conflict");
}

}  // namespace
}  // namespace roomcast::hub
