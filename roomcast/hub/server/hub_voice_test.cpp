// SPDX-License-Identifier: Apache-2.0
// Voice through a running hub: who hears, and what a hostile speaker achieves.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/hub/server/hub_server.h"
#include "roomcast/hub/server/hub_server_fixture.h"

namespace roomcast::hub {
namespace {

net::FramedMessagePtr audio_packet(std::uint32_t seq, std::size_t payload_bytes = 80) {
  const wire::AudioHeader header{.speaker = ViewerId{4711},
                                 .seq = seq,
                                 .capture_time = RoomTime(SteadyClock().now().time_since_epoch()),
                                 .payload_length = static_cast<std::uint16_t>(payload_bytes)};
  std::vector<std::uint8_t> bytes(wire::kAudioHeaderBytes + payload_bytes, 0x55);
  wire::write_audio_header(header, std::span(bytes).first<wire::kAudioHeaderBytes>());
  return net::frame_message(net::MessageBuffer(bytes));
}

/// Also for a hub whose room only admins may speak in.
class HubVoiceTest : public HubServerTest {
 protected:
  explicit HubVoiceTest(HubOptions options = {}) : HubServerTest(std::move(options)) {}

  std::shared_ptr<RawClient> join(bool hears, bool as_admin = false) {
    pb::Control control = join_as_viewer();
    control.mutable_join()->mutable_viewer()->set_hears(hears);
    if (as_admin) control.mutable_join()->set_token(hub->own_token());
    auto client = connect(control);
    run_until([&] { return !client->received.empty(); });
    return client;
  }
  /// As an admin who plays a recording.
  std::shared_ptr<RawClient> play(const std::string& recording) {
    pb::Control control = join_as_viewer();
    control.mutable_join()->mutable_viewer()->set_hears(true);
    control.mutable_join()->mutable_viewer()->set_plays(recording);
    control.mutable_join()->set_token(hub->own_token());
    auto client = connect(control);
    run_until([&] { return !client->received.empty(); });
    return client;
  }
  /// `client` must be the newest one.
  void send(RawClient& client, const net::FramedMessagePtr& message, int times = 1) {
    for (int i = 0; i < times; ++i) client.send(message);
    sockets.back()->wake();
  }
  void expect_refusal(const RawClient& client, pb::ErrorCode code) {
    run_until([&] { return client.closed.has_value(); });
    const auto& last = client.received.back();
    EXPECT_EQ(last.error().code(), code) << last.error().sentence();
    EXPECT_FALSE(last.error().sentence().empty());
  }
};

TEST_F(HubVoiceTest, audio_reaches_listeners_and_no_earlier_viewer) {
  const auto listener = join(true), earlier = join(false), speaker = join(true);
  EXPECT_TRUE(speaker->received.at(0).welcome().may_speak());
  send(*speaker, audio_packet(7));
  run_until([&] { return !listener->audio.empty(); });
  EXPECT_EQ(listener->audio[0].seq, 7U);
  EXPECT_EQ(listener->audio[0].speaker.value, speaker->received.at(0).welcome().viewer_id());
  EXPECT_TRUE(earlier->audio.empty());
  EXPECT_TRUE(speaker->audio.empty());
  EXPECT_TRUE(std::ranges::none_of(earlier->received, &pb::Control::has_voices));
}

TEST_F(HubVoiceTest, somebody_who_floods_is_disconnected_and_the_others_go_on) {
  const auto listener = join(true), flooder = join(true);
  send(*flooder, audio_packet(0), 400);
  expect_refusal(*flooder, pb::ERROR_TOO_FAST);
  EXPECT_LE(listener->audio.size(), 151U);
  const auto speaker = join(true);
  send(*speaker, audio_packet(1));
  run_until([&] {
    return std::ranges::any_of(listener->audio, [](const auto& h) { return h.seq == 1; });
  });
  EXPECT_FALSE(listener->closed);
}

TEST_F(HubVoiceTest, large_packets_use_up_the_bytes_of_a_speaker) {
  const auto flooder = join(true);
  send(*flooder, audio_packet(0, wire::kMaxAudioPayloadBytes), 100);
  expect_refusal(*flooder, pb::ERROR_TOO_FAST);
}

TEST_F(HubVoiceTest, an_oversized_packet_is_refused) {
  const auto speaker = join(true);
  send(*speaker, audio_packet(0, wire::kMaxAudioPayloadBytes + 1));
  expect_refusal(*speaker, pb::ERROR_TOO_LARGE);
}

TEST_F(HubVoiceTest, the_sound_of_a_sensors_microphone_reaches_listeners) {
  const auto listener = join(true);
  const auto sensor = connect(join_as_sensor("left"));
  run_until([&] { return !sensor->received.empty(); });
  const pb::Welcome welcome = sensor->received.at(0).welcome();
  EXPECT_TRUE(welcome.may_speak());
  send(*sensor, audio_packet(3));
  run_until([&] { return !listener->audio.empty(); });
  const auto id = static_cast<std::uint16_t>(welcome.sensor_id());
  EXPECT_EQ(wire::sensor_of(listener->audio.at(0).speaker), SensorId{id});
  EXPECT_EQ(listener->audio.at(0).seq, 3U);
}

TEST_F(HubVoiceTest, a_sensor_that_floods_with_audio_is_disconnected) {
  const auto sensor = connect(join_as_sensor("left"));
  run_until([&] { return !sensor->received.empty(); });
  send(*sensor, audio_packet(0), 200);
  expect_refusal(*sensor, pb::ERROR_TOO_FAST);
}

TEST_F(HubVoiceTest, somebody_who_has_not_joined_does_not_speak) {
  const auto stranger = connect(std::deque{audio_packet(0)});
  expect_refusal(*stranger, pb::ERROR_UNEXPECTED);
}

TEST_F(HubVoiceTest, who_plays_a_recording_gets_the_voices_of_those_who_play_it_and_no_frames) {
  const auto in_room = join(true);
  const auto other = play("tuesday"), listener = play("monday");
  const auto sensor = connect(join_as_sensor("left"));
  run_until([&] { return !sensor->received.empty(); });
  send(*sensor, key_frame(0));
  run_until([&] { return !in_room->frames.empty(); });
  const auto speaker = play("monday");
  send(*speaker, audio_packet(7));
  run_until([&] { return !listener->audio.empty(); });
  EXPECT_EQ(listener->audio[0].speaker.value, speaker->received.at(0).welcome().viewer_id());
  EXPECT_TRUE(in_room->audio.empty());
  EXPECT_TRUE(other->audio.empty());
  EXPECT_TRUE(listener->frames.empty());
  EXPECT_TRUE(std::ranges::none_of(listener->received, &pb::Control::has_roster));
}

TEST_F(HubVoiceTest, a_player_who_floods_is_disconnected_and_the_others_go_on) {
  const auto listener = play("monday"), flooder = play("monday");
  send(*flooder, audio_packet(0), 400);
  expect_refusal(*flooder, pb::ERROR_TOO_FAST);
  const auto speaker = play("monday");
  send(*speaker, audio_packet(1));
  run_until([&] {
    return std::ranges::any_of(listener->audio, [](const auto& h) { return h.seq == 1; });
  });
  EXPECT_FALSE(listener->closed);
}

class SilentRoomTest : public HubVoiceTest {
 protected:
  SilentRoomTest() : HubVoiceTest({.rooms = {{.name = "room", .speak = AccessRule::kAdmin}}}) {}
};

TEST_F(SilentRoomTest, only_those_may_speak_whom_the_rooms_rules_let) {
  const auto guest = join(true);
  EXPECT_FALSE(guest->received.at(0).welcome().may_speak());
  send(*guest, audio_packet(0));
  expect_refusal(*guest, pb::ERROR_NOT_ALLOWED);
  EXPECT_TRUE(join(true, true)->received.at(0).welcome().may_speak());
  const auto sensor = connect(join_as_sensor("left"));
  run_until([&] { return !sensor->received.empty(); });
  EXPECT_FALSE(sensor->received.at(0).welcome().may_speak());
}

}  // namespace
}  // namespace roomcast::hub
