// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "roomcast/hub/room/room_test_fixture.h"

namespace roomcast::hub {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

pb::Join player_join(const std::string& recording, const std::string& name = "Ada") {
  pb::Join join = viewer_join(name);
  join.mutable_viewer()->set_hears(true);
  join.mutable_viewer()->set_plays(recording);
  return join;
}

class RoomPlaybackTest : public RoomTest {
 protected:
  ConnectionId play(const std::string& recording, const std::string& token_id = "") {
    return enter(player_join(recording), 0s, {.token_id = token_id, .may_speak = true});
  }
  RoomActions speak(ConnectionId from, nanoseconds now) {
    const wire::AudioHeader header{.capture_time = at(now), .payload_length = 1};
    std::vector<std::uint8_t> bytes(wire::kAudioHeaderBytes + 1);
    wire::write_audio_header(header, std::span(bytes).first<wire::kAudioHeaderBytes>());
    return room.audio(from, header, net::MessageBuffer(bytes), at(now));
  }
  std::vector<ConnectionId> who_hears(ConnectionId from, nanoseconds now) {
    const auto sent = all<SendAudio>(speak(from, now));
    return sent.empty() ? std::vector<ConnectionId>() : sent[0].to;
  }
};

TEST_F(RoomPlaybackTest, those_who_play_the_same_recording_hear_each_other_and_nobody_else) {
  pb::Join listener = viewer_join("in the room");
  listener.mutable_viewer()->set_hears(true);
  const auto live = enter(listener, 0s, {.may_speak = true});
  const auto ada = play("monday");
  const auto bob = play("monday");
  const auto cleo = play("tuesday");
  EXPECT_THAT(who_hears(ada, 1s), ElementsAre(bob));
  EXPECT_THAT(who_hears(bob, 1s), ElementsAre(ada));
  EXPECT_THAT(who_hears(cleo, 1s), IsEmpty());
  EXPECT_THAT(who_hears(live, 1s), IsEmpty());
  EXPECT_EQ(room.stats().speakers, 4U);
}

TEST_F(RoomPlaybackTest, a_player_gets_nothing_of_the_room) {
  const auto sensor = enter(sensor_join("left"));
  const auto ada = play("monday");
  EXPECT_THAT(messages(actions, pb::Control::kRoster), IsEmpty());
  EXPECT_THAT(messages(actions, pb::Control::kMarks), IsEmpty());
  EXPECT_EQ(all<AcceptConnection>(actions).at(0).role, Role::kPlayer);
  EXPECT_FALSE(messages(actions, pb::Control::kWelcome).at(0).message.welcome().may_mark());
  EXPECT_FALSE(room.stats().frames_wanted) << "nobody watches";
  for (const auto& action : {frame(sensor, SensorId{0}, 1s, 1s), room.tick(at(2s))}) {
    EXPECT_THAT(all<SendSet>(action), IsEmpty());
    for (const auto& sent : all<SendControl>(action))
      EXPECT_EQ(std::ranges::find(sent.to, ada), sent.to.end());
  }
}

TEST_F(RoomPlaybackTest, people_in_the_room_do_not_see_a_player) {
  const auto live = enter(viewer_join("in the room"));
  play("monday");
  (void)room.leave(live, at(1s));
  enter(viewer_join("again"), 2s);
  EXPECT_EQ(newest_roster(actions).viewers_size(), 1);
  EXPECT_EQ(newest_roster(actions).viewers(0).name(), "again");
}

TEST_F(RoomPlaybackTest, admins_see_who_plays_what) {
  play("monday", "t1");
  const auto stats = room.stats();
  ASSERT_EQ(stats.viewers.size(), 1U);
  EXPECT_EQ(stats.viewers[0].plays, "monday");
  EXPECT_EQ(stats.viewers[0].token_id, "t1");
}

TEST_F(RoomPlaybackTest, a_muted_player_is_heard_by_nobody_and_knows_it) {
  const auto ada = play("monday", "t1");
  const auto bob = play("monday");
  const auto told = messages(room.mute(ViewerId{1}, true, at(1s)), pb::Control::kVoices);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told[0].to, UnorderedElementsAre(ada, bob));
  EXPECT_THAT(told[0].message.voices().muted(), ElementsAre(1));
  EXPECT_THAT(who_hears(ada, 2s), IsEmpty());
  EXPECT_TRUE(room.stats().viewers[0].muted);
  (void)room.leave(ada, at(3s));
  EXPECT_THAT(who_hears(play("tuesday", "t1"), 4s), IsEmpty()) << "the token is muted";
  pb::Join live = viewer_join("in the room, too");
  live.mutable_viewer()->set_hears(true);
  enter(live);
  EXPECT_THAT(who_hears(enter(live, 0s, {.token_id = "t1", .may_speak = true}), 5s), IsEmpty());
}

TEST_F(RoomPlaybackTest, who_may_not_speak_there_is_refused_with_a_sentence) {
  const auto ada = enter(player_join("monday"));
  const auto refused = all<Disconnect>(speak(ada, 1s));
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].code, pb::ERROR_NOT_ALLOWED);
  EXPECT_THAT(room.stats().viewers, IsEmpty());
}

TEST_F(RoomPlaybackTest, a_player_changes_nothing_in_the_room) {
  for (const auto& spoil : std::vector<void (*)(pb::Control&)>{
           [](pb::Control& c) { c.mutable_key_request(); },
           [](pb::Control& c) { c.mutable_guide()->set_on(true); },
           [](pb::Control& c) { c.mutable_mark(); },
           [](pb::Control& c) { c.mutable_nudge(); },
           [](pb::Control& c) { c.mutable_people_here(); },
       }) {
    const auto ada = enter(player_join("monday"), 0s, {.may_place = true, .may_mark = true});
    pb::Control message;
    spoil(message);
    const auto refused = all<Disconnect>(room.control(ada, message, at(1s)));
    ASSERT_EQ(refused.size(), 1U) << message.DebugString();
    EXPECT_EQ(refused[0].code, pb::ERROR_UNEXPECTED);
  }
}

TEST_F(RoomPlaybackTest, the_nearest_of_many_are_heard) {
  const auto stand = [this](ConnectionId who, float x) {
    pb::Control pose;
    pose.mutable_viewer_pose()->mutable_head()->set_x(x);
    EXPECT_THAT(room.control(who, pose, at(0s)), IsEmpty());
  };
  const auto listener = play("monday");
  stand(listener, 0);
  std::vector<ConnectionId> speakers;
  for (int i = 0; i < 9; ++i) {
    speakers.push_back(play("monday"));
    stand(speakers.back(), static_cast<float>(9 - i));
  }
  for (const auto from : speakers) (void)speak(from, 1s);
  for (const auto from : speakers) (void)speak(from, 1200ms);
  const auto reaches = [&](ConnectionId from) {
    const auto to = who_hears(from, 1220ms);
    return std::ranges::find(to, listener) != to.end();
  };
  EXPECT_FALSE(reaches(speakers[0])) << "the farthest";
  EXPECT_TRUE(reaches(speakers[8]));
}

TEST_F(RoomPlaybackTest, who_has_left_is_gone_and_told_to_the_others) {
  const auto ada = play("monday");
  const auto bob = play("monday");
  (void)speak(ada, 1s);
  (void)room.tick(at(1s));
  (void)room.leave(ada, at(1100ms));
  EXPECT_EQ(room.next_tick(), at(1200ms));
  const auto told = messages(room.tick(at(1200ms)), pb::Control::kVoices);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told[0].to, ElementsAre(bob));
  EXPECT_THAT(told[0].message.voices().speaking(), IsEmpty());
  EXPECT_THAT(room.connections(), ElementsAre(bob));
  (void)room.leave(bob, at(2s));
  EXPECT_THAT(room.connections(), IsEmpty());
}

TEST_F(RoomPlaybackTest, players_count_among_the_viewers_of_a_full_room) {
  (void)room.change({.name = "lab", .max_viewers = 2}, at(0s));
  enter(viewer_join());
  play("monday");
  play("monday");
  const auto refused = all<Disconnect>(actions);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].code, pb::ERROR_ROOM_FULL);
}

}  // namespace
}  // namespace roomcast::hub
