// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/room/room_state.h"

#include <gtest/gtest.h>

#include "roomcast/client/room/calibration_message.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::client {
namespace {

constexpr int kWidth = 32, kHeight = 24;

wire::pb::SensorEntry sensor_entry(unsigned id, int width = kWidth) {
  SensorCalibration calibration;
  calibration.depth = {.width = width, .height = kHeight, .fx = 30, .fy = 30, .cx = 16, .cy = 12};
  calibration.color = calibration.depth;
  calibration.color_is_registered = true;
  wire::pb::SensorEntry entry;
  entry.set_id(id);
  entry.set_name("s" + std::to_string(id));
  entry.set_online(true);
  entry.set_fps(30);
  entry.set_placement(wire::pb::PLACEMENT_GIVEN);
  *entry.mutable_calibration() = message_from_calibration(calibration);
  wire::write_transform({}, *entry.mutable_world_from_depth());
  return entry;
}

DepthImage depth_picture(std::uint16_t shift) {
  DepthImage depth(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x)
      depth.at(x, y) = static_cast<std::uint16_t>(1000 + shift + 3 * x + y);
  }
  return depth;
}

/// A sensor that sends depth without colour; by default each frame can be decoded alone.
class SendingSensor {
 public:
  SendingSensor() {
    codec::FrameEncoderOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.depth_mode = codec::DepthMode::kLossless;
    encoder_ = std::move(*codec::FrameEncoder::create(options));
  }

  std::vector<std::uint8_t> message(wire::FrameHeader header, const DepthImage& depth) {
    std::vector<std::uint8_t> bytes(wire::kFrameHeaderBytes);
    EXPECT_TRUE(encoder_->encode(depth, {}, {}, true, bytes).ok());
    header.payload_length = static_cast<std::uint32_t>(bytes.size() - wire::kFrameHeaderBytes);
    wire::write_frame_header(header, std::span(bytes).first<wire::kFrameHeaderBytes>());
    return bytes;
  }

 private:
  std::unique_ptr<codec::FrameEncoder> encoder_;
};

wire::FrameHeader header_of(unsigned sensor, std::uint32_t seq, bool key = true) {
  wire::FrameHeader header;
  header.key = key;
  header.last = true;
  header.sensor = SensorId{static_cast<std::uint16_t>(sensor)};
  header.seq = seq;
  header.base_seq = key ? seq : seq - 1;
  header.set = SetId{seq + 1};
  return header;
}

class RoomStateTest : public testing::Test {
 protected:
  RoomStateTest() {
    wire::pb::Welcome welcome;
    welcome.set_room("lab");
    state.welcome(welcome);
    wire::pb::Roster roster;
    *roster.add_sensors() = sensor_entry(0);
    *roster.add_sensors() = sensor_entry(1);
    EXPECT_TRUE(state.roster(roster).ok());
  }

  FakeClock clock;
  RoomState state{clock};
  SendingSensor sensor;
};

wire::pb::Roster roster_with(std::initializer_list<unsigned> viewers) {
  wire::pb::Roster roster;
  for (const unsigned id : viewers) {
    auto& entry = *roster.add_viewers();
    entry.set_id(id);
    entry.set_name("v" + std::to_string(id));
    entry.set_color_rgb(0x102030);
  }
  return roster;
}

wire::pb::ViewerPoses poses_of(unsigned viewer, float x) {
  wire::pb::ViewerPoses poses;
  auto& pose = *poses.add_poses();
  pose.set_viewer_id(viewer);
  pose.mutable_head()->set_x(x);
  pose.mutable_head()->set_qw(1);
  return poses;
}

TEST(RoomState, knows_its_rights_from_the_last_welcome) {
  const SteadyClock clock;
  RoomState room(clock);
  EXPECT_FALSE(room.snapshot()->rights.may_record);
  wire::pb::Welcome welcome;
  welcome.set_may_record(true);
  room.welcome(welcome);
  EXPECT_TRUE(check_may_record(room.snapshot()->rights).ok());
  EXPECT_EQ(check_may_export(room.snapshot()->rights).error().message,
            "this room does not let viewers export");
  room.welcome({});
  EXPECT_FALSE(check_may_record(room.snapshot()->rights).ok());
}

TEST_F(RoomStateTest, people_are_those_of_the_roster_at_their_newest_poses) {
  state.poses(poses_of(7, 1));  // not in the roster
  ASSERT_TRUE(state.roster(roster_with({7, 8})).ok());
  EXPECT_FALSE(state.snapshot()->people[0].pose);
  state.poses(poses_of(7, 2));
  state.poses(poses_of(7, 3));
  ASSERT_TRUE(state.roster(roster_with({6, 7})).ok());
  const auto room = state.snapshot();
  ASSERT_EQ(room->people.size(), 2U);
  EXPECT_FALSE(room->people[0].pose);
  EXPECT_EQ(room->people[1].name, "v7");
  EXPECT_EQ(room->people[1].color, (Rgb8{0x10, 0x20, 0x30}));
  ASSERT_TRUE(room->people[1].pose);
  EXPECT_EQ(room->people[1].pose->world_from_head.translation_m.x(), 3);
}

TEST_F(RoomStateTest, without_a_connection_it_lists_no_people) {
  ASSERT_TRUE(state.roster(roster_with({7})).ok());
  state.disconnected("the hub has gone");
  EXPECT_TRUE(state.snapshot()->people.empty());
}

TEST_F(RoomStateTest, frames_that_did_not_come_are_counted) {
  for (const std::uint32_t seq : {10U, 11U, 14U, 3U}) {
    ASSERT_TRUE(state.frame(sensor.message(header_of(0, seq), depth_picture(0))).ok());
  }
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 9, false), depth_picture(0))).ok());
  const auto room = state.snapshot();
  EXPECT_EQ(room->sensors[0].frames_received, 4U);
  EXPECT_EQ(room->sensors[0].frames_missed, 2U + 5U + 1U) << "12, 13; 4 to 8; and 9 needs its base";
  EXPECT_EQ(room->sensors[0].bytes_received, room->bytes_received);
}

TEST_F(RoomStateTest, renditions_are_numbered_each_by_itself) {
  const auto comes = [&](std::uint32_t seq, bool is_small) {
    wire::FrameHeader header = header_of(0, seq);
    header.small = is_small;
    EXPECT_TRUE(state.frame(sensor.message(header, depth_picture(0))).ok());
    EXPECT_EQ(state.snapshot()->sensors[0].is_small, is_small);
  };
  comes(10, false);
  comes(500, true);
  comes(502, true);
  comes(900, false);
  EXPECT_EQ(state.snapshot()->sensors[0].frames_missed, 1U) << "501";
}

TEST_F(RoomStateTest, a_picture_says_when_it_came) {
  clock.advance(std::chrono::seconds(5));
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 0), depth_picture(0))).ok());
  EXPECT_EQ(state.snapshot()->sensors[0].picture->received, clock.now());
}

TEST_F(RoomStateTest, pictures_arrive_bit_for_bit) {
  const DepthImage depth = depth_picture(7);
  const auto outcome = state.frame(sensor.message(header_of(1, 0), depth));
  ASSERT_TRUE(outcome.ok()) << outcome.error().message;
  EXPECT_EQ(*outcome, RoomState::FrameOutcome::kSetComplete);
  const auto room = state.snapshot();
  ASSERT_EQ(room->sensors.size(), 2u);
  EXPECT_EQ(room->sensors[0].picture, nullptr);
  ASSERT_NE(room->sensors[1].picture, nullptr);
  EXPECT_EQ(room->sensors[1].picture->frame.depth_mm, depth);
  EXPECT_EQ(room->newest_set, SetId{1});
  EXPECT_EQ(room->sets_received, 1u);
}

TEST_F(RoomStateTest, a_snapshot_keeps_its_pictures_while_new_ones_come) {
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 0), depth_picture(0))).ok());
  const auto before = state.snapshot();
  for (std::uint32_t seq = 1; seq < 5; ++seq) {
    ASSERT_TRUE(state
                    .frame(sensor.message(header_of(0, seq),
                                          depth_picture(static_cast<std::uint16_t>(seq))))
                    .ok());
  }
  EXPECT_EQ(before->sensors[0].picture->frame.depth_mm, depth_picture(0));
  EXPECT_EQ(state.snapshot()->sensors[0].picture->frame.depth_mm, depth_picture(4));
  EXPECT_GT(state.snapshot()->revision, before->revision);
}

TEST_F(RoomStateTest, a_frame_without_its_base_asks_for_a_key_frame) {
  const auto outcome = state.frame(sensor.message(header_of(0, 5, false), depth_picture(0)));
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(*outcome, RoomState::FrameOutcome::kNeedsKey);
}

TEST_F(RoomStateTest, frames_that_are_left_out_because_nobody_sees_them_are_not_missed) {
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 0), depth_picture(0))).ok());
  wire::pb::UnseenSensors unseen;
  unseen.add_base_only(0);
  state.unseen(unseen);
  EXPECT_FALSE(state.snapshot()->sensors[0].is_paused);
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 2), depth_picture(0))).ok());
  unseen.clear_base_only();
  unseen.add_paused(0);
  unseen.add_paused(77);  // is unknown
  state.unseen(unseen);
  EXPECT_TRUE(state.snapshot()->sensors[0].is_paused);
  state.unseen({});
  EXPECT_TRUE(state.snapshot()->sensors[0].is_paused) << "its picture is still old";
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 50), depth_picture(0))).ok());
  EXPECT_FALSE(state.snapshot()->sensors[0].is_paused);
  EXPECT_EQ(state.snapshot()->sensors[0].frames_missed, 0U);
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 52), depth_picture(0))).ok());
  EXPECT_EQ(state.snapshot()->sensors[0].frames_missed, 1U) << "now everything is to come";
}

TEST_F(RoomStateTest, of_a_sensor_that_is_held_back_frames_are_not_missed) {
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 0), depth_picture(0))).ok());
  wire::pb::UnseenSensors unseen;
  unseen.add_held_back(0);
  state.unseen(unseen);
  EXPECT_TRUE(state.snapshot()->sensors[0].is_held_back);
  EXPECT_FALSE(state.snapshot()->sensors[0].is_paused) << "its picture stays";
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 90), depth_picture(0))).ok());
  EXPECT_TRUE(state.snapshot()->sensors[0].is_held_back) << "it was a key frame";
  EXPECT_EQ(state.snapshot()->sensors[0].frames_missed, 0U);
  state.unseen({});
  EXPECT_FALSE(state.snapshot()->sensors[0].is_held_back);
}

TEST_F(RoomStateTest, a_set_may_end_without_its_last_frame) {
  wire::FrameHeader header = header_of(0, 4);
  header.last = false;
  const auto outcome = state.frame(sensor.message(header, depth_picture(0)));
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(*outcome, RoomState::FrameOutcome::kDecoded);
  EXPECT_TRUE(state.set_ended(header.set));
  EXPECT_FALSE(state.set_ended(header.set)) << "once";
  EXPECT_FALSE(state.set_ended(SetId{header.set.value + 1})) << "no frame of it has come";
  EXPECT_EQ(state.snapshot()->sets_received, 1U);
}

TEST_F(RoomStateTest, a_damaged_payload_asks_for_a_key_frame_and_later_frames_wait_for_it) {
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 0), depth_picture(0))).ok());
  auto damaged = sensor.message(header_of(0, 1, false), depth_picture(1));
  std::fill(damaged.begin() + wire::kFrameHeaderBytes, damaged.end(), std::uint8_t{0xFF});
  EXPECT_EQ(*state.frame(damaged), RoomState::FrameOutcome::kNeedsKey);
  EXPECT_EQ(*state.frame(sensor.message(header_of(0, 2, false), depth_picture(2))),
            RoomState::FrameOutcome::kNeedsKey);
  EXPECT_EQ(*state.frame(sensor.message(header_of(0, 3), depth_picture(3))),
            RoomState::FrameOutcome::kSetComplete);
}

TEST_F(RoomStateTest, frames_of_unannounced_sensors_are_refused) {
  EXPECT_FALSE(state.frame(sensor.message(header_of(9, 0), depth_picture(0))).ok());
}

TEST_F(RoomStateTest, a_sensor_that_comes_back_with_another_grid_starts_anew) {
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 0), depth_picture(0))).ok());
  wire::pb::Roster roster;
  *roster.add_sensors() = sensor_entry(0, kWidth + 2);
  ASSERT_TRUE(state.roster(roster).ok());
  EXPECT_EQ(state.snapshot()->sensors[0].picture, nullptr);
  EXPECT_EQ(*state.frame(sensor.message(header_of(0, 1), depth_picture(1))),
            RoomState::FrameOutcome::kNeedsKey)
      << "a picture of the old size is not drawn on the new grid";
}

TEST_F(RoomStateTest, a_sensor_that_the_room_has_forgotten_is_gone) {
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 0), depth_picture(0))).ok());
  wire::pb::Roster roster;
  *roster.add_sensors() = sensor_entry(0);
  ASSERT_TRUE(state.roster(roster).ok());
  ASSERT_EQ(state.snapshot()->sensors.size(), 1U);
  EXPECT_NE(state.snapshot()->sensors[0].picture, nullptr);
  roster.mutable_sensors(0)->set_name("another that has its id");
  ASSERT_TRUE(state.roster(roster).ok());
  ASSERT_EQ(state.snapshot()->sensors.size(), 1U);
  EXPECT_EQ(state.snapshot()->sensors[0].picture, nullptr);
  EXPECT_EQ(*state.frame(sensor.message(header_of(0, 1, false), depth_picture(1))),
            RoomState::FrameOutcome::kNeedsKey);
}

TEST_F(RoomStateTest, a_lost_connection_keeps_the_room_and_says_why) {
  ASSERT_TRUE(state.frame(sensor.message(header_of(0, 0), depth_picture(0))).ok());
  state.disconnected("the hub has gone");
  const auto room = state.snapshot();
  EXPECT_FALSE(room->connected);
  EXPECT_EQ(room->problem, "the hub has gone");
  EXPECT_NE(room->sensors[0].picture, nullptr);
}

TEST_F(RoomStateTest, sensors_whose_microphones_are_heard_are_known) {
  wire::pb::Voices voices;
  voices.add_speaking(wire::speaker_of(SensorId{1}).value);
  voices.add_muted(wire::speaker_of(SensorId{0}).value);
  state.voices(voices);
  const auto room = state.snapshot();
  EXPECT_FALSE(room->sensors[0].speaking);
  EXPECT_TRUE(room->sensors[0].muted);
  EXPECT_TRUE(room->sensors[1].speaking);
  state.disconnected("away");
  EXPECT_FALSE(state.snapshot()->sensors[1].speaking);
}

}  // namespace
}  // namespace roomcast::client
