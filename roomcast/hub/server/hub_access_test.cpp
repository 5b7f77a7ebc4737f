// SPDX-License-Identifier: Apache-2.0
// Admission to the rooms of a running hub, over real connections, while a sensor sends. A refused
// client gets the reason and not a single frame.
#include "roomcast/core/temporary_folder.h"
#include "roomcast/hub/server/hub_server.h"
#include "roomcast/hub/server/hub_server_fixture.h"
#include "roomcast/hub/store/hub_store.h"

namespace roomcast::hub {
namespace {

const std::vector<RoomSettings> kRooms = {
    {.name = "lab", .send = AccessRule::kToken, .view = AccessRule::kToken},
    {.name = "cellar", .listed = false, .send = AccessRule::kToken, .view = AccessRule::kToken},
    {.name = "open"}};

/// A base class, so that it outlives the hub.
struct WithFolder {
  TemporaryFolder folder;
};

class HubAccessTest : protected WithFolder, public HubServerTest {
 protected:
  HubAccessTest()
      : HubServerTest({.rooms = kRooms,
                       .data_folder = folder.path(),
                       .limits = {.bans = {.faults = 1000}, .proxies = {}}}) {}

  std::string token(const std::string& room, TokenRole role, UnixSeconds ttl = 600,
                    const std::string& name = "") {
    return store->issue({.room = room, .role = role, .name = name}, ttl)->token;
  }

  static pb::Control with(pb::Control join, const std::string& room, const std::string& shown) {
    join.mutable_join()->set_room(room);
    join.mutable_join()->set_token(shown);
    return join;
  }

  std::shared_ptr<RawClient> welcomed(const pb::Control& join) {
    auto client = connect(join);
    run_until([&] { return !client->received.empty(); });
    EXPECT_TRUE(client->received.at(0).has_welcome()) << client->received.at(0).error().sentence();
    return client;
  }

  /// Expects a refusal with this code, while frames flow in the room and reach an admitted viewer.
  void expect_refused(const pb::Control& join, pb::ErrorCode code) {
    const auto sensor =
        welcomed(with(join_as_sensor("left"), "lab", token("lab", TokenRole::kSensor)));
    auto& socket = *sockets.back();
    const auto id = SensorId{static_cast<std::uint16_t>(sensor->received[0].welcome().sensor_id())};
    ASSERT_EQ(id.value, 0);
    const auto friendly = welcomed(with(join_as_viewer(), "lab", token("lab", TokenRole::kViewer)));
    const auto stranger = connect(join);
    for (std::uint32_t seq = 0; seq < 5; ++seq) {
      sensor->send(key_frame(seq));
      socket.wake();
      run_until([&] { return friendly->frames.size() > seq; });
    }
    run_until([&] { return stranger->closed.has_value(); });
    ASSERT_EQ(stranger->received.size(), 1U);
    EXPECT_EQ(stranger->received[0].error().code(), code)
        << stranger->received[0].error().sentence();
    EXPECT_FALSE(stranger->received[0].error().sentence().empty());
    EXPECT_TRUE(stranger->frames.empty());
  }

  UnixSeconds now = wall_time();
  std::unique_ptr<HubStore> store = *HubStore::open(folder.path(), [this] { return now; });
};

TEST_F(HubAccessTest, a_room_that_needs_a_token_refuses_clients_without_one) {
  expect_refused(with(join_as_viewer(), "lab", ""), pb::ERROR_UNAUTHENTICATED);
}

TEST_F(HubAccessTest, an_expired_token_is_refused) {
  now -= 1000;
  const std::string old = token("lab", TokenRole::kViewer, 10);
  now += 1000;
  expect_refused(with(join_as_viewer(), "lab", old), pb::ERROR_TOKEN_EXPIRED);
}

TEST_F(HubAccessTest, another_rooms_token_is_refused) {
  expect_refused(with(join_as_viewer(), "lab", token("cellar", TokenRole::kViewer)),
                 pb::ERROR_WRONG_ROOM);
}

TEST_F(HubAccessTest, a_sensor_token_does_not_admit_a_viewer) {
  expect_refused(with(join_as_viewer(), "lab", token("lab", TokenRole::kSensor)),
                 pb::ERROR_WRONG_ROLE);
}

TEST_F(HubAccessTest, a_viewer_token_does_not_admit_a_sensor) {
  expect_refused(with(join_as_sensor("right"), "lab", token("lab", TokenRole::kViewer)),
                 pb::ERROR_WRONG_ROLE);
}

TEST_F(HubAccessTest, a_tampered_token_is_refused) {
  std::string shown = token("lab", TokenRole::kViewer);
  shown[shown.size() / 2] = shown[shown.size() / 2] == 'A' ? 'Q' : 'A';
  expect_refused(with(join_as_viewer(), "lab", shown), pb::ERROR_TOKEN_INVALID);
}

TEST_F(HubAccessTest, a_revoked_token_is_refused) {
  const auto made = *store->issue({.room = "lab", .role = TokenRole::kViewer}, 600);
  ASSERT_TRUE(store->revoke(made.claims.id).ok());
  expect_refused(with(join_as_viewer(), "lab", made.token), pb::ERROR_TOKEN_REVOKED);
}

TEST_F(HubAccessTest, a_code_is_exchanged_once_and_its_token_stays_valid) {
  auto join = with(join_as_viewer(), "", "");
  join.mutable_join()->set_code(
      store->issue_code({.room = "lab", .role = TokenRole::kViewer}, 600)->code);
  const auto viewer = welcomed(join);
  const std::string received = viewer->received[0].welcome().token();
  EXPECT_FALSE(received.empty());
  EXPECT_EQ(viewer->received[0].welcome().room(), "lab");
  (void)welcomed(with(join_as_viewer(), "lab", received));
  expect_refused(join, pb::ERROR_CODE_USED);
}

TEST_F(HubAccessTest, a_private_and_a_missing_room_answer_alike) {
  const auto there = connect(with(join_as_viewer(), "cellar", ""));
  const auto nowhere = connect(with(join_as_viewer(), "nowhere", ""));
  run_until([&] { return there->closed && nowhere->closed; });
  EXPECT_EQ(there->received[0].SerializeAsString(), nowhere->received[0].SerializeAsString());
  EXPECT_EQ(there->received[0].error().code(), pb::ERROR_NO_SUCH_ROOM);
  EXPECT_EQ(there->closed->code, nowhere->closed->code);
}

TEST_F(HubAccessTest, a_viewer_gets_no_messages_of_another_room) {
  const auto sensor =
      welcomed(with(join_as_sensor("left"), "lab", token("lab", TokenRole::kSensor)));
  auto& socket = *sockets.back();
  const auto inside = welcomed(with(join_as_viewer(), "lab", token("lab", TokenRole::kViewer)));
  const auto outside = welcomed(with(join_as_viewer(), "open", ""));
  for (std::uint32_t seq = 0; seq < 5; ++seq) {
    sensor->send(key_frame(seq));
    socket.wake();
    run_until([&] { return inside->frames.size() > seq; });
  }
  const auto late = welcomed(with(join_as_viewer(), "open", ""));
  run_until([&] { return outside->received.back().has_roster(); });
  EXPECT_TRUE(outside->frames.empty());
  for (const auto& message : outside->received) {
    EXPECT_EQ(message.roster().sensors_size(), 0);
    EXPECT_LE(message.roster().viewers_size(), 2);
  }
}

TEST_F(HubAccessTest, the_name_of_an_online_sensor_is_reserved) {
  const auto sensor =
      welcomed(with(join_as_sensor("left"), "lab", token("lab", TokenRole::kSensor)));
  const auto thief = connect(with(join_as_sensor("left"), "lab", token("lab", TokenRole::kSensor)));
  run_until([&] { return thief->closed.has_value(); });
  EXPECT_EQ(thief->received.at(0).error().code(), pb::ERROR_WRONG_ROLE);
  EXPECT_FALSE(sensor->closed);
}

TEST_F(HubAccessTest, a_frame_before_the_welcome_ends_the_connection) {
  const auto hasty = connect(
      {framed_control(with(join_as_sensor("left"), "lab", token("lab", TokenRole::kSensor))),
       key_frame(0)});
  run_until([&] { return hasty->closed.has_value(); });
  EXPECT_EQ(hasty->received.back().error().code(), pb::ERROR_UNEXPECTED);
}

TEST_F(HubAccessTest, a_client_is_disconnected_when_another_program_revokes_its_token) {
  const auto made = *store->issue({.room = "lab", .role = TokenRole::kViewer}, 600);
  const auto viewer = welcomed(with(join_as_viewer(), "lab", made.token));
  ASSERT_TRUE(store->revoke(made.claims.id).ok());
  run_until([&] { return viewer->closed.has_value(); });
  EXPECT_EQ(viewer->received.back().error().code(), pb::ERROR_TOKEN_REVOKED);
}

TEST_F(HubAccessTest, a_client_is_disconnected_when_its_token_expires) {
  const auto viewer = welcomed(with(join_as_viewer(), "lab", token("lab", TokenRole::kViewer, 2)));
  run_until([&] { return viewer->closed.has_value(); });
  EXPECT_EQ(viewer->received.back().error().code(), pb::ERROR_TOKEN_EXPIRED);
}

TEST_F(HubAccessTest, the_hubs_own_token_admits_to_every_room) {
  EXPECT_TRUE(welcomed(with(join_as_viewer(), "cellar", hub->own_token()))
                  ->received[0]
                  .welcome()
                  .may_place());
}

class ConnectionLimitTest : public HubServerTest {
 protected:
  ConnectionLimitTest() : HubServerTest({.limits = {.max_unsettled_per_peer = 4, .proxies = {}}}) {}
};

TEST_F(ConnectionLimitTest, limits_the_unjoined_connections_of_one_address) {
  for (int i = 0; i < 6; ++i) {
    const auto viewer = connect(join_as_viewer());
    run_until([&] { return !viewer->received.empty(); });
  }
  for (int i = 0; i < 4; ++i) (void)connect(std::deque<net::FramedMessagePtr>());
  bool answered = false;
  net::connect(io, {.host = "127.0.0.1", .port = hub->port()}, {}, [&](const auto& connection) {
    answered = true;
    EXPECT_FALSE(connection.ok());
  });
  run_until([&] { return answered; });
}

}  // namespace
}  // namespace roomcast::hub
