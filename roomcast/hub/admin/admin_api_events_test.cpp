// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/admin_api_fixture.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;
using Json = nlohmann::json;

/// A sensor that answers as it is told; nothing: not at all.
class AskedSensor final : public Connection {
 public:
  AskedSensor(ConnectionId id, std::optional<std::string> refusal)
      : Connection(id), refusal_(std::move(refusal)) {}
  void accept(Role, RoomId) override {}
  void deliver(ControlFanOut& control) override {
    if (control.message().has_settings_request()) asked = control.message().settings_request();
  }
  void disconnect(pb::ErrorCode, const std::string&) override {}
  void answer(RoomRegistry& registry) {
    if (!asked || !refusal_) return;
    pb::Control message;
    message.mutable_settings_answer()->set_number(asked->number());
    message.mutable_settings_answer()->set_refusal(*refusal_);
    registry.on_control(id(), message);
  }

  std::optional<pb::SettingsRequest> asked;

 private:
  const std::optional<std::string> refusal_;
};

class AdminApiEventsTest : public AdminApiTest {
 protected:
  void join(const ConnectionPtr& connection, const std::string& name, bool takes_settings) {
    pb::Join join;
    join.set_room("lab");
    join.set_name(name);
    join.mutable_sensor()->set_fps(30);
    if (takes_settings) join.mutable_sensor()->mutable_settings()->set_codec("live");
    registry.on_join({.connection = connection, .address = "10.0.0.9:1", .peer = "10.0.0.9"}, join);
  }
  Json events(const std::string& more = "") {
    return ask("GET", "/rooms/lab/events" + more, hub_admin).body["events"];
  }
  /// Asks, and lets the sensor answer meanwhile.
  Answer change(AskedSensor& sensor, const Json& body) {
    boost::asio::post(io, [this, &sensor] {
      boost::asio::post(io, [this, &sensor] { answer_when_asked(sensor); });
    });
    return ask("PATCH", "/rooms/lab/sensors/s0", hub_admin, body);
  }
  void answer_when_asked(AskedSensor& sensor) {
    if (sensor.asked) return sensor.answer(registry);
    boost::asio::post(io, [this, &sensor] { answer_when_asked(sensor); });
  }
};

TEST_F(AdminApiEventsTest, tell_who_came_who_was_refused_and_what_an_admin_did) {
  const auto sensor = std::make_shared<AskedSensor>(ConnectionId{1}, "");
  join(sensor, "s0", true);
  pb::Join stranger;
  stranger.set_room("lab");
  stranger.set_name("Eve");
  stranger.mutable_viewer();
  const auto eve = std::make_shared<QuietConnection>(ConnectionId{2});
  registry.on_join({.connection = eve, .address = "10.0.0.8:1", .peer = "10.0.0.8"}, stranger);
  ask("PATCH", "/rooms/lab", hub_admin, {{"title", "The lab"}, {"max_viewers", 9}});
  registry.on_left(ConnectionId{1}, {.sentence = "gone"});
  const Json list = events();
  ASSERT_EQ(list.size(), 4U) << list;
  EXPECT_EQ(list[0]["kind"], "joined");
  EXPECT_EQ(list[0]["role"], "sensor");
  EXPECT_EQ(list[0]["peer"], "10.0.0.9:1");
  EXPECT_EQ(list[1]["kind"], "refused");
  EXPECT_EQ(list[1]["name"], "Eve");
  EXPECT_NE(list[1]["sentence"], "");
  EXPECT_EQ(list[2]["kind"], "changed_room");
  EXPECT_EQ(list[2]["sentence"], "max_viewers, title");
  EXPECT_NE(list[2]["by"], "");
  EXPECT_EQ(list[3]["kind"], "left");
  EXPECT_EQ(list[3]["sentence"], "gone");
  EXPECT_EQ(events("/after/3").size(), 1U);
  EXPECT_EQ(ask("GET", "/rooms/lab/events/after/x", hub_admin).status, 400);
}

TEST_F(AdminApiEventsTest, are_for_the_rooms_admins_only) {
  EXPECT_EQ(ask("GET", "/rooms/lab/events").status, 401);
  EXPECT_EQ(ask("GET", "/rooms/lab/events", token("lab", TokenRole::kViewer)).status, 403);
  EXPECT_EQ(ask("GET", "/rooms/lab/events", token("cellar", TokenRole::kAdmin)).status, 403);
  EXPECT_EQ(ask("GET", "/rooms/lab/events", token("lab", TokenRole::kAdmin)).status, 200);
  const auto sensor = std::make_shared<AskedSensor>(ConnectionId{1}, "");
  join(sensor, "s0", true);
  const Json restart = {{"restart", true}};
  EXPECT_EQ(ask("PATCH", "/rooms/lab/sensors/s0", token("lab", TokenRole::kSensor), restart).status,
            403);
  EXPECT_FALSE(sensor->asked);
}

TEST_F(AdminApiEventsTest, a_sensor_applies_what_an_admin_asks_for) {
  const auto sensor = std::make_shared<AskedSensor>(ConnectionId{1}, "");
  join(sensor, "s0", true);
  EXPECT_EQ(change(*sensor, {{"codec", "lossless"}}).status, 202);
  EXPECT_EQ(sensor->asked->settings().codec(), "lossless");
  const Json list = events();
  EXPECT_EQ(list.back()["kind"], "changed_sensor");
  EXPECT_EQ(list.back()["sentence"], "codec lossless");
  const Json sensors = ask("GET", "/rooms/lab/sensors", hub_admin).body["sensors"];
  EXPECT_EQ(sensors[0]["settings"]["codec"], "live") << "until it joins with the others";
}

TEST_F(AdminApiEventsTest, a_sensors_refusal_is_told_in_its_words) {
  const auto sensor = std::make_shared<AskedSensor>(ConnectionId{1}, "I cannot");
  join(sensor, "s0", true);
  const Answer answer = change(*sensor, {{"fps", 10}});
  EXPECT_EQ(answer.status, 400);
  EXPECT_EQ(answer.body["error"]["sentence"], "I cannot");
  EXPECT_EQ(events().back()["kind"], "sensor_refused");
}

TEST_F(AdminApiEventsTest, a_sensor_that_takes_no_settings_is_not_asked) {
  const auto sensor = std::make_shared<AskedSensor>(ConnectionId{1}, "");
  join(sensor, "s0", false);
  const Answer answer = ask("PATCH", "/rooms/lab/sensors/s0", hub_admin, {{"restart", true}});
  EXPECT_EQ(answer.status, 400);
  EXPECT_FALSE(sensor->asked);
  EXPECT_EQ(ask("PATCH", "/rooms/lab/sensors/s9", hub_admin, {{"restart", true}}).status, 404);
  EXPECT_EQ(ask("PATCH", "/rooms/lab/sensors/s0", hub_admin, {{"colour", 1}}).status, 400);
}

}  // namespace
}  // namespace roomcast::hub
