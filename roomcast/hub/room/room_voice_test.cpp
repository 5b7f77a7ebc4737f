// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "roomcast/hub/room/room_test_fixture.h"

namespace roomcast::hub {
namespace {

using testing::IsEmpty;
using testing::UnorderedElementsAre;

pb::Join listener_join() {
  pb::Join join = viewer_join("Ada");
  join.mutable_viewer()->set_hears(true);
  return join;
}

class RoomVoiceTest : public RoomTest {
 protected:
  ConnectionId enter_speaker(const std::string& token_id = "") {
    return enter(listener_join(), 0s, {.token_id = token_id, .may_speak = true});
  }
  RoomActions speak(ConnectionId from, nanoseconds now, std::uint32_t claimed_id = 0) {
    wire::AudioHeader header{
        .speaker = ViewerId{claimed_id}, .capture_time = at(now), .payload_length = 1};
    std::vector<std::uint8_t> bytes(wire::kAudioHeaderBytes + 1);
    wire::write_audio_header(header, std::span(bytes).first<wire::kAudioHeaderBytes>());
    return room.audio(from, header, net::MessageBuffer(bytes), at(now));
  }
};

TEST_F(RoomVoiceTest, audio_goes_to_listeners_only_with_the_speakers_id) {
  const auto speaker = enter_speaker();
  const auto listener = enter(listener_join());
  enter(viewer_join("an earlier viewer"));
  const auto sent = all<SendAudio>(speak(speaker, 1s, 77));
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_THAT(sent[0].to, UnorderedElementsAre(listener));
  EXPECT_EQ(wire::parse_audio(sent[0].packet->payload())->speaker, ViewerId{1});
}

TEST_F(RoomVoiceTest, welcome_says_who_may_speak) {
  enter_speaker();
  EXPECT_TRUE(messages(actions, pb::Control::kWelcome).at(0).message.welcome().may_speak());
  enter(listener_join());
  EXPECT_FALSE(messages(actions, pb::Control::kWelcome).at(0).message.welcome().may_speak());
}

TEST_F(RoomVoiceTest, who_may_not_speak_is_refused_with_a_sentence) {
  const auto listener = enter(listener_join());
  const auto sensor = enter(sensor_join("left"));
  for (const auto from : {listener, sensor}) {
    const auto refused = all<Disconnect>(speak(from, 1s));
    ASSERT_EQ(refused.size(), 1U);
    EXPECT_EQ(refused[0].code, pb::ERROR_NOT_ALLOWED);
    EXPECT_FALSE(refused[0].sentence.empty());
  }
}

TEST_F(RoomVoiceTest, audio_of_the_future_is_refused) {
  const auto speaker = enter_speaker();
  const wire::AudioHeader header{.capture_time = at(10s)};
  const auto refused = all<Disconnect>(room.audio(speaker, header, {}, at(1s)));
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].code, pb::ERROR_MALFORMED);
}

TEST_F(RoomVoiceTest, listeners_are_told_who_speaks_until_half_a_second_of_silence) {
  const auto speaker = enter_speaker();
  const auto listener = enter(listener_join());
  EXPECT_EQ(messages(actions, pb::Control::kVoices).size(), 1U) << "on joining";
  (void)speak(speaker, 1s);
  auto told = messages(room.tick(at(1s)), pb::Control::kVoices);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told[0].to, UnorderedElementsAre(speaker, listener));
  EXPECT_EQ(told[0].message.voices().speaking(0), 1U);
  EXPECT_EQ(room.stats().speakers, 1U);
  EXPECT_TRUE(room.stats().viewers[0].speaks);
  told = messages(room.tick(at(1500ms)), pb::Control::kVoices);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].message.voices().speaking_size(), 0);
  EXPECT_EQ(room.stats().audio_packets, 1U);
}

TEST_F(RoomVoiceTest, a_muted_person_stays_in_the_room_and_is_not_heard) {
  const auto speaker = enter_speaker();
  enter(listener_join());
  const auto told = messages(room.mute(ViewerId{1}, true, at(1s)), pb::Control::kVoices);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].message.voices().muted(0), 1U);
  EXPECT_THAT(speak(speaker, 2s), IsEmpty());
  EXPECT_TRUE(room.stats().viewers[0].muted);
  (void)room.mute(ViewerId{1}, false, at(3s));
  EXPECT_EQ(all<SendAudio>(speak(speaker, 4s)).size(), 1U);
}

TEST_F(RoomVoiceTest, who_joins_again_with_a_muted_token_is_muted) {
  const auto speaker = enter_speaker("t1");
  enter(listener_join());
  (void)room.mute(ViewerId{1}, true, at(1s));
  (void)room.leave(speaker, at(2s));
  const auto again = enter_speaker("t1");
  EXPECT_THAT(all<SendAudio>(speak(again, 3s)), IsEmpty());
  const auto other = enter_speaker("t2");
  EXPECT_EQ(all<SendAudio>(speak(other, 3s)).size(), 1U);
}

TEST_F(RoomVoiceTest, nearest_speakers_are_found_by_head_poses) {
  std::vector<ConnectionId> speakers;
  for (int i = 0; i < 9; ++i) speakers.push_back(enter_speaker());
  const auto listener = enter(listener_join());
  const auto stand = [&](ConnectionId who, float x) {
    pb::Control pose;
    pose.mutable_viewer_pose()->mutable_head()->set_x(x);
    (void)room.control(who, pose, at(0s));
  };
  stand(listener, 0);
  for (std::size_t i = 0; i < 9; ++i) stand(speakers[i], static_cast<float>(9 - i));
  for (const auto from : speakers) (void)speak(from, 1s);
  for (const auto from : speakers) (void)speak(from, 1200ms);
  const auto reaches = [&](ConnectionId from) {
    const auto sent = all<SendAudio>(speak(from, 1220ms));
    return std::ranges::find(sent.at(0).to, listener) != sent.at(0).to.end();
  };
  EXPECT_FALSE(reaches(speakers[0])) << "the farthest";
  EXPECT_TRUE(reaches(speakers[8]));
}

TEST_F(RoomVoiceTest, a_recorder_gets_voices_while_the_owner_permits_it_and_all_are_told) {
  const auto speaker = enter_speaker();
  pb::Join join = listener_join();
  join.mutable_viewer()->set_records(true);
  const auto recorder = enter(join);
  const auto told = [this] {
    const auto rosters = messages(actions, pb::Control::kRoster);
    for (const auto& viewer : rosters.at(0).message.roster().viewers())
      if (viewer.records()) return viewer.records_voices();
    ADD_FAILURE() << "no recorder in the roster";
    return false;
  };
  EXPECT_TRUE(told());
  EXPECT_THAT(all<SendAudio>(speak(speaker, 1s)).at(0).to, UnorderedElementsAre(recorder));
  actions = room.change({.name = "lab", .record_voices = false}, at(2s));
  EXPECT_FALSE(told());
  EXPECT_THAT(all<SendAudio>(speak(speaker, 2s)), IsEmpty());
  actions = room.change({.name = "lab"}, at(3s));
  EXPECT_TRUE(told());
  EXPECT_THAT(all<SendAudio>(speak(speaker, 3s)).at(0).to, UnorderedElementsAre(recorder));
}

TEST_F(RoomVoiceTest, a_recorder_that_joins_a_room_whose_voices_are_not_recorded_gets_none) {
  (void)room.change({.name = "lab", .record_voices = false}, at(0s));
  const auto speaker = enter_speaker();
  pb::Join join = listener_join();
  join.mutable_viewer()->set_records(true);
  enter(join);
  EXPECT_THAT(all<SendAudio>(speak(speaker, 1s)), IsEmpty());
}

TEST_F(RoomVoiceTest, a_sensors_microphone_is_heard_under_an_id_of_its_own) {
  const auto listener = enter(listener_join());
  const auto sensor = enter(sensor_join("left"), 0s, {.may_speak = true});
  EXPECT_TRUE(messages(actions, pb::Control::kWelcome).at(0).message.welcome().may_speak());
  EXPECT_FALSE(room.stats().sensors[0].has_microphone);
  const auto sent = all<SendAudio>(speak(sensor, 1s));
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_THAT(sent[0].to, UnorderedElementsAre(listener));
  EXPECT_EQ(wire::parse_audio(sent[0].packet->payload())->speaker,
            wire::speaker_of(room.stats().sensors[0].id));
  EXPECT_TRUE(room.stats().sensors[0].has_microphone);
  EXPECT_TRUE(room.stats().sensors[0].speaks);
  (void)room.leave(sensor, at(2s));
  EXPECT_FALSE(room.stats().sensors[0].speaks);
}

TEST_F(RoomVoiceTest, a_muted_microphone_stays_muted_until_the_sensor_is_forgotten) {
  enter(listener_join());
  auto sensor = enter(sensor_join("left"), 0s, {.may_speak = true});
  const ViewerId speaker = wire::speaker_of(room.stats().sensors[0].id);
  const auto told = messages(room.mute(speaker, true, at(1s)), pb::Control::kVoices);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].message.voices().muted(0), speaker.value);
  (void)room.leave(sensor, at(2s));
  sensor = enter(sensor_join("left"), 3s, {.may_speak = true});
  EXPECT_THAT(speak(sensor, 4s), IsEmpty());
  EXPECT_TRUE(room.stats().sensors[0].muted);
  (void)room.leave(sensor, at(5s));
  (void)room.forget("left", at(6s));
  sensor = enter(sensor_join("left"), 7s, {.may_speak = true});
  EXPECT_EQ(all<SendAudio>(speak(sensor, 8s)).size(), 1U);
}

TEST_F(RoomVoiceTest, a_near_microphone_is_heard_among_many_speakers) {
  const auto listener = enter(listener_join());
  pb::Control pose;
  pose.mutable_viewer_pose()->mutable_head()->set_x(0);
  (void)room.control(listener, pose, at(0s));
  const auto near = enter(sensor_join("near", pose_at(1)), 0s, {.may_speak = true});
  const auto unplaced = enter(sensor_join("somewhere", std::nullopt), 0s, {.may_speak = true});
  std::vector<ConnectionId> speakers = {near, unplaced};
  for (int i = 0; i < 7; ++i) {
    speakers.push_back(enter_speaker());
    pose.mutable_viewer_pose()->mutable_head()->set_x(static_cast<float>(2 + i));
    (void)room.control(speakers.back(), pose, at(0s));
  }
  for (const auto from : speakers) (void)speak(from, 1s);
  for (const auto from : speakers) (void)speak(from, 1200ms);
  const auto reaches = [&](ConnectionId from) {
    const auto sent = all<SendAudio>(speak(from, 1220ms));
    return std::ranges::find(sent.at(0).to, listener) != sent.at(0).to.end();
  };
  EXPECT_TRUE(reaches(near));
  EXPECT_FALSE(reaches(unplaced));
}

}  // namespace
}  // namespace roomcast::hub
