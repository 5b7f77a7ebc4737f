// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/admin_api.h"

#include "roomcast/hub/admin/admin_api_fixture.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;
using Json = nlohmann::json;

TEST_F(AdminApiTest, logs_changes_and_refusals) {
  const Answer viewer = ask("POST", "/tokens", hub_admin, {{"room", "lab"}, {"role", "viewer"}});
  ASSERT_EQ(viewer.status, 201);
  EXPECT_EQ(logged["method"], "POST");
  EXPECT_EQ(logged["about"], viewer.body["id"]);
  EXPECT_EQ(logged["peer"], "10.0.0.7");
  EXPECT_FALSE(logged["token"].empty()) << "of the hub's admin";
  logged.clear();
  ask("GET", "/rooms", hub_admin);
  EXPECT_TRUE(logged.empty()) << "nothing was changed";
  ask("DELETE", "/rooms/lab", viewer.body["token"]);
  EXPECT_EQ(logged["token"], viewer.body["id"]);
  EXPECT_EQ(logged["error"], "wrong_role");
  ask("DELETE", "/rooms/lab", "guessed");
  EXPECT_EQ(logged["token"], "");
  EXPECT_EQ(logged["error"], "invalid_token");
}

TEST_F(AdminApiTest, anonymous_callers_see_listed_rooms_only) {
  const Answer rooms = ask("GET", "/rooms");
  ASSERT_EQ(rooms.body["rooms"].size(), 1U);
  EXPECT_EQ(rooms.body["rooms"][0]["name"], "lab");
  EXPECT_EQ(ask("GET", "/rooms/cellar").body, ask("GET", "/rooms/nowhere").body);
  EXPECT_EQ(ask("GET", "/rooms", hub_admin).body["rooms"].size(), 2U);
  EXPECT_EQ(ask("GET", "/rooms", token("cellar", TokenRole::kViewer)).body["rooms"].size(), 2U);
}

TEST_F(AdminApiTest, a_private_room_is_hidden_from_other_admins) {
  const std::string other = token("lab", TokenRole::kAdmin);
  for (const char* what : {"", "/sensors", "/viewers"}) {
    const std::string tail = what;
    EXPECT_EQ(ask("GET", "/rooms/cellar" + tail, other).body,
              ask("GET", "/rooms/nowhere" + tail, other).body);
  }
}

TEST_F(AdminApiTest, calls_that_need_a_token_request_it) {
  for (const AdminRoute& route : admin_routes()) {
    if (!route.needs_token) continue;
    std::string path(route.path);
    for (const char* name : {"{room}", "{sensor}", "{viewer}", "{id}"}) {
      if (const auto at = path.find(name); at != std::string::npos) {
        path.replace(at, std::string(name).size(), "lab");
      }
    }
    const std::string method(route.method);
    EXPECT_EQ(ask(method, path).code(), "unauthenticated") << method << path;
    EXPECT_EQ(ask(method, path, "guessed").code(), "invalid_token") << method << path;
    EXPECT_EQ(ask(method, path, token("lab", TokenRole::kViewer), Json::object()).status / 100, 4)
        << method << path;
  }
}

TEST_F(AdminApiTest, a_room_is_opened_changed_and_closed) {
  const Answer opened =
      ask("POST", "/rooms", hub_admin, {{"name", "registry"}, {"max_viewers", 9}});
  EXPECT_EQ(opened.status, 201);
  EXPECT_EQ(opened.body["view"], "token") << "a room is closed until its owner opens it";
  EXPECT_EQ(ask("POST", "/rooms", hub_admin, {{"name", "registry"}}).code(), "conflict");
  const Answer changed = ask("PATCH", "/rooms/registry", hub_admin, {{"title", "The registry"}});
  EXPECT_EQ(changed.body["title"], "The registry");
  EXPECT_EQ(changed.body["max_viewers"], 9);
  EXPECT_EQ(ask("DELETE", "/rooms/registry", hub_admin).status, 204);
  EXPECT_EQ(ask("GET", "/rooms/registry", hub_admin).code(), "not_found");
}

TEST_F(AdminApiTest, a_configured_room_cannot_be_closed) {
  const Answer refused = ask("DELETE", "/rooms/lab", hub_admin);
  EXPECT_EQ(refused.status, 409);
  EXPECT_EQ(refused.code(), "conflict");
  EXPECT_EQ(ask("GET", "/rooms/lab", hub_admin).status, 200);
}

TEST_F(AdminApiTest, tokens_of_a_closed_room_do_not_admit_to_its_successor) {
  ASSERT_EQ(ask("POST", "/rooms", hub_admin, {{"name", "registry"}}).status, 201);
  const std::string before = token("registry", TokenRole::kAdmin);
  EXPECT_EQ(ask("GET", "/rooms/registry/sensors", before).status, 200);
  ASSERT_EQ(ask("DELETE", "/rooms/registry", hub_admin).status, 204);
  ASSERT_EQ(ask("POST", "/rooms", hub_admin, {{"name", "registry"}}).status, 201);
  EXPECT_EQ(ask("GET", "/rooms/registry/sensors", before).code(), "revoked");
  EXPECT_EQ(ask("GET", "/rooms/registry/sensors", token("registry", TokenRole::kAdmin)).status,
            200);
}

TEST_F(AdminApiTest, invalid_requests_are_refused_with_a_sentence) {
  EXPECT_EQ(ask("POST", "/rooms", hub_admin, Json::array()).code(), "bad_request");
  EXPECT_EQ(ask("POST", "/rooms", hub_admin, {{"title", "nameless"}}).code(), "bad_request");
  EXPECT_EQ(ask("PATCH", "/rooms/lab", hub_admin, {{"name", "attic"}}).code(), "bad_request");
  EXPECT_EQ(ask("PATCH", "/rooms/lab", hub_admin, {{"view", "friends"}}).code(), "bad_request");
  EXPECT_EQ(ask("POST", "/tokens", hub_admin, {{"room", "lab"}}).code(), "bad_request");
  EXPECT_EQ(ask("PUT", "/rooms", hub_admin).code(), "method_not_allowed");
  EXPECT_EQ(ask("GET", "/nothing", hub_admin).code(), "not_found");
}

TEST_F(AdminApiTest, a_rooms_admin_may_change_only_that_room) {
  const std::string admin = token("lab", TokenRole::kAdmin);
  EXPECT_EQ(ask("PATCH", "/rooms/lab", admin, {{"title", "Mine"}}).status, 200);
  EXPECT_EQ(ask("GET", "/rooms/lab/sensors", admin).status, 200);
  EXPECT_EQ(ask("DELETE", "/rooms/lab", admin).code(), "wrong_role");
  EXPECT_EQ(ask("POST", "/rooms", admin, {{"name", "more"}}).code(), "wrong_role");
  EXPECT_EQ(ask("GET", "/status", admin).code(), "wrong_role");
  EXPECT_EQ(ask("POST", "/tokens", admin, {{"room", "cellar"}, {"role", "viewer"}}).code(),
            "wrong_role");
  EXPECT_EQ(ask("POST", "/tokens", admin, {{"room", "*"}, {"role", "admin"}}).code(), "wrong_role");
}

TEST_F(AdminApiTest, tokens_are_made_listed_and_revoked) {
  const Answer made =
      ask("POST", "/tokens", hub_admin, {{"room", "lab"}, {"role", "admin"}, {"ttl_s", 60}});
  EXPECT_EQ(made.status, 201);
  const std::string shown = made.body["token"], id = made.body["id"];
  EXPECT_EQ(ask("GET", "/tokens", shown).body["tokens"][0]["id"], id);
  EXPECT_EQ(ask("DELETE", "/tokens/" + id, hub_admin).status, 204);
  EXPECT_EQ(ask("GET", "/tokens", shown).code(), "revoked");
  EXPECT_EQ(ask("GET", "/tokens", hub_admin).body["tokens"][0]["revoked"], true);
  EXPECT_EQ(ask("DELETE", "/tokens/nobodys", hub_admin).code(), "not_found");
}

TEST_F(AdminApiTest, tokens_of_other_rooms_are_hidden) {
  const std::string admin = token("lab", TokenRole::kAdmin);
  const Answer made = ask("POST", "/tokens", hub_admin, {{"room", "cellar"}, {"role", "viewer"}});
  EXPECT_EQ(ask("DELETE", "/tokens/" + made.body["id"].get<std::string>(), admin).code(),
            "not_found");
  EXPECT_EQ(ask("GET", "/tokens", admin).body["tokens"].size(), 1U);
}

TEST_F(AdminApiTest, a_code_has_the_fragment_of_a_link) {
  const Answer made =
      ask("POST", "/tokens", hub_admin, {{"room", "lab"}, {"role", "viewer"}, {"once", true}});
  EXPECT_FALSE(made.body.contains("token"));
  EXPECT_TRUE(made.body["fragment"].get<std::string>().starts_with("#room=lab&code="));
}

TEST_F(AdminApiTest, an_unused_code_is_listed_and_revoked) {
  const Answer made =
      ask("POST", "/tokens", hub_admin, {{"room", "lab"}, {"role", "viewer"}, {"once", true}});
  const std::string id = made.body["id"];
  const Answer tokens = ask("GET", "/tokens", hub_admin);
  EXPECT_EQ(tokens.body["tokens"][0]["id"], id);
  EXPECT_EQ(tokens.body["tokens"][0]["once"], true);
  EXPECT_EQ(tokens.body.dump().find(made.body["code"].get<std::string>()), std::string::npos);
  EXPECT_EQ(ask("DELETE", "/tokens/" + id, token("cellar", TokenRole::kAdmin)).code(), "not_found");
  EXPECT_EQ(ask("DELETE", "/tokens/" + id, hub_admin).status, 204);
  EXPECT_EQ(ask("GET", "/tokens", token("lab", TokenRole::kAdmin)).body["tokens"][1]["revoked"],
            true);
}

TEST_F(AdminApiTest, an_absent_client_cannot_be_disconnected) {
  EXPECT_EQ(ask("DELETE", "/rooms/lab/sensors/left", hub_admin).code(), "not_found");
  EXPECT_EQ(ask("DELETE", "/rooms/lab/viewers/7", hub_admin).code(), "not_found");
  EXPECT_EQ(ask("DELETE", "/rooms/lab/viewers/x", hub_admin).code(), "not_found");
}

TEST_F(AdminApiTest, a_viewer_is_muted_until_that_is_ended) {
  const auto viewer = std::make_shared<QuietConnection>(ConnectionId{1});
  pb::Join join;
  join.set_room("lab");
  join.set_token(token("lab", TokenRole::kViewer));
  join.mutable_viewer();
  registry.on_join({.connection = viewer, .address = "10.0.0.7:5", .peer = "10.0.0.7"}, join);
  const auto viewers = [this] { return ask("GET", "/rooms/lab/viewers", hub_admin).body; };
  while (viewers()["viewers"].empty()) io.run_one_for(std::chrono::milliseconds(100));
  EXPECT_EQ(viewers()["viewers"][0]["muted"], false);
  const Answer muted = ask("PATCH", "/rooms/lab/viewers/1", hub_admin, {{"muted", true}});
  EXPECT_EQ(muted.status, 200);
  EXPECT_EQ(muted.body["muted"], true);
  EXPECT_EQ(viewers()["viewers"][0]["muted"], true);
  EXPECT_EQ(ask("PATCH", "/rooms/lab/viewers/1", hub_admin, {{"muted", false}}).body["muted"],
            false);
}

TEST_F(AdminApiTest, muting_needs_a_viewer_a_boolean_and_an_admin) {
  EXPECT_EQ(ask("PATCH", "/rooms/lab/viewers/7", hub_admin, {{"muted", true}}).code(), "not_found");
  EXPECT_EQ(ask("PATCH", "/rooms/lab/viewers/7", hub_admin, {{"muted", 1}}).code(), "bad_request");
  EXPECT_EQ(ask("PATCH", "/rooms/lab/viewers/7", hub_admin, {{"name", "x"}}).code(), "bad_request");
  EXPECT_EQ(
      ask("PATCH", "/rooms/lab/viewers/7", token("lab", TokenRole::kViewer), {{"muted", true}})
          .code(),
      "wrong_role");
}

TEST_F(AdminApiTest, a_sensors_microphone_is_muted_until_that_is_ended) {
  const auto sensor = std::make_shared<QuietConnection>(ConnectionId{1});
  pb::Join join;
  join.set_room("lab");
  join.set_name("left");
  join.set_token(token("lab", TokenRole::kAdmin));
  join.mutable_sensor()->set_fps(30);
  registry.on_join({.connection = sensor, .address = "10.0.0.7:5", .peer = "10.0.0.7"}, join);
  const auto sensors = [this] { return ask("GET", "/rooms/lab/sensors", hub_admin).body; };
  while (sensors()["sensors"].empty()) io.run_one_for(std::chrono::milliseconds(100));
  EXPECT_EQ(ask("PATCH", "/rooms/lab/sensors/left", hub_admin, {{"muted", true}}).body["muted"],
            true);
  EXPECT_EQ(sensors()["sensors"][0]["muted"], true);
  EXPECT_EQ(ask("PATCH", "/rooms/lab/sensors/left", hub_admin, {{"muted", false}}).body["muted"],
            false);
  EXPECT_EQ(ask("PATCH", "/rooms/lab/sensors/left", hub_admin, {{"muted", 1}}).code(),
            "bad_request");
  EXPECT_EQ(ask("PATCH", "/rooms/lab/sensors/right", hub_admin, {{"muted", true}}).code(),
            "not_found");
}

TEST_F(AdminApiTest, an_offline_sensor_can_be_forgotten) {
  ASSERT_EQ(ask("POST", "/rooms", hub_admin, {{"name", "registry"}}).status, 201);
  std::optional<Status> kept;
  store_worker.ask(
      [](HubStore& kept_in) {
        return kept_in.sensors().save("registry", std::vector{KnownSensor{"left", SensorId{0}}});
      },
      [&](const Status& status) { kept = status; });
  EXPECT_EQ(
      ask("DELETE", "/rooms/registry/sensors/left", token("registry", TokenRole::kViewer)).code(),
      "wrong_role");
  EXPECT_EQ(ask("DELETE", "/rooms/registry/sensors/left", hub_admin).status, 204);
  EXPECT_EQ(ask("DELETE", "/rooms/registry/sensors/left", hub_admin).code(), "not_found");
  EXPECT_TRUE(kept && kept->ok());
}

TEST_F(AdminApiTest, the_hub_reports_its_state) {
  const Answer status = ask("GET", "/status", hub_admin);
  EXPECT_EQ(status.body["rooms"], 2);
  EXPECT_EQ(status.body["version"], "test");
}

}  // namespace
}  // namespace roomcast::hub
