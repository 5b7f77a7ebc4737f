// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/frame_synchronizer.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kFps = 20;  // a period of 50 ms
constexpr SensorId kLeft{0}, kRight{1};

RoomTime captured_at(nanoseconds since_start) {
  return RoomTime(1h + since_start);
}

net::MessageBuffer message_of(wire::FrameHeader header) {
  std::vector<std::uint8_t> bytes(wire::kFrameHeaderBytes + 3, 7);
  header.payload_length = 3;
  wire::write_frame_header(header, std::span(bytes).first<wire::kFrameHeaderBytes>());
  return net::MessageBuffer(bytes);
}

class Builder : public testing::Test {
 protected:
  Builder() {
    builder.add_sensor(kLeft, kFps);
    builder.add_sensor(kRight, kFps);
  }

  bool add(SensorId sensor, nanoseconds captured, nanoseconds arrived) {
    wire::FrameHeader header{.sensor = sensor, .capture_time = captured_at(captured)};
    return builder.add_frame(header, message_of(header), captured_at(arrived));
  }

  /// The sensors of each set that has closed, sorted.
  std::vector<std::vector<int>> closed(nanoseconds now) {
    std::vector<std::vector<int>> sets;
    for (const auto& set : builder.take_closed(captured_at(now))) {
      auto& sensors = sets.emplace_back();
      for (const auto& frame : set->frames) sensors.push_back(frame.header.sensor.value);
      std::sort(sensors.begin(), sensors.end());
    }
    return sets;
  }

  /// Lets both sensors deliver once, so that sets wait for both.
  void both_deliver_once() {
    add(kLeft, 0ms, 0ms);
    add(kRight, 0ms, 0ms);
    closed(0ms);
  }

  FrameSynchronizer builder;
};

TEST_F(Builder, a_set_closes_when_all_sensors_have_delivered) {
  both_deliver_once();
  add(kLeft, 50ms, 52ms);
  EXPECT_THAT(closed(53ms), IsEmpty());
  add(kRight, 54ms, 56ms);
  EXPECT_THAT(closed(56ms), ElementsAre(ElementsAre(0, 1)));
}

TEST_F(Builder, a_set_does_not_wait_beyond_its_deadline) {
  both_deliver_once();
  add(kLeft, 50ms, 52ms);
  EXPECT_EQ(builder.next_deadline(), captured_at(102ms));
  EXPECT_THAT(closed(101ms), IsEmpty());
  EXPECT_THAT(closed(102ms), ElementsAre(ElementsAre(0)));
  EXPECT_EQ(builder.next_deadline(), std::nullopt);
}

TEST_F(Builder, a_small_frame_comes_in_the_set_of_the_full_one_ahead_of_it) {
  both_deliver_once();
  wire::FrameHeader small{.small = true, .sensor = kLeft, .capture_time = captured_at(50ms)};
  EXPECT_TRUE(builder.add_frame(small, message_of(small), captured_at(51ms)));
  EXPECT_EQ(builder.next_deadline(), std::nullopt) << "it opens no set";
  add(kLeft, 50ms, 52ms);
  add(kRight, 54ms, 56ms);
  const auto sets = builder.take_closed(captured_at(56ms));
  ASSERT_EQ(sets.size(), 1u);
  const auto& frames = sets[0]->frames;
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_TRUE(frames[0].header.small);
  EXPECT_FALSE(frames[1].header.small);
  EXPECT_EQ(frames[1].header.sensor, kLeft);
  EXPECT_TRUE(frames[2].header.last);
}

TEST_F(Builder, small_frames_without_full_ones_are_bounded) {
  wire::FrameHeader small{.small = true, .sensor = kLeft};
  int taken = 0;
  for (int i = 0; i < 100; ++i)
    taken += builder.add_frame(small, message_of(small), captured_at(0ms));
  EXPECT_EQ(taken, static_cast<int>(FrameSynchronizer::kMaxFramesOfSensorInSet));
}

TEST_F(Builder, the_deadline_is_a_period_where_that_is_longer) {
  FrameSynchronizer slow;
  slow.add_sensor(kLeft, 5);
  slow.add_sensor(kRight, 5);
  wire::FrameHeader header{.sensor = kLeft, .capture_time = captured_at(0ms)};
  slow.add_frame(header, message_of(header), captured_at(0ms));
  header.sensor = kRight;
  slow.add_frame(header, message_of(header), captured_at(0ms));
  EXPECT_EQ(slow.take_closed(captured_at(0ms)).size(), 1u);
  header.capture_time = captured_at(200ms);
  slow.add_frame(header, message_of(header), captured_at(200ms));
  EXPECT_EQ(slow.next_deadline(), captured_at(400ms));
}

TEST_F(Builder, nobody_waits_for_a_sensor_that_has_not_delivered_yet) {
  add(kLeft, 0ms, 1ms);
  EXPECT_THAT(closed(1ms), ElementsAre(ElementsAre(0)));
}

TEST_F(Builder, nobody_waits_for_a_sensor_that_left) {
  both_deliver_once();
  add(kLeft, 50ms, 52ms);
  builder.remove_sensor(kRight);
  EXPECT_THAT(closed(53ms), ElementsAre(ElementsAre(0)));
}

TEST_F(Builder, nobody_waits_for_a_paused_sensor) {
  both_deliver_once();
  builder.pause_sensor(kRight, true);
  add(kLeft, 50ms, 52ms);
  EXPECT_THAT(closed(53ms), ElementsAre(ElementsAre(0)));
  add(kRight, 54ms, 60ms);  // it was on its way
  closed(160ms);
  add(kLeft, 150ms, 152ms);
  EXPECT_THAT(closed(153ms), ElementsAre(ElementsAre(0)));
  builder.pause_sensor(kRight, false);
  add(kLeft, 200ms, 202ms);
  EXPECT_THAT(closed(203ms), ElementsAre(ElementsAre(0))) << "nor before its next frame";
  add(kLeft, 250ms, 252ms);
  add(kRight, 251ms, 253ms);
  EXPECT_THAT(closed(254ms), ElementsAre(ElementsAre(0, 1)));
  add(kLeft, 300ms, 302ms);
  EXPECT_THAT(closed(303ms), IsEmpty());
}

TEST_F(Builder, a_sensor_that_sends_every_second_frame_is_awaited_for_these) {
  both_deliver_once();
  for (int i = 1; i <= 4; ++i) {
    add(kLeft, i * 50ms, i * 50ms + 2ms);
    if (i % 2 == 0) add(kRight, i * 50ms, i * 50ms + 3ms);
    closed(i * 50ms + 49ms);
    closed(i * 50ms + 53ms);
  }
  add(kLeft, 250ms, 252ms);
  EXPECT_THAT(closed(253ms), ElementsAre(ElementsAre(0)));
  add(kLeft, 300ms, 302ms);
  EXPECT_THAT(closed(303ms), IsEmpty());
  add(kRight, 300ms, 304ms);
  EXPECT_THAT(closed(304ms), ElementsAre(ElementsAre(0, 1)));
}

TEST_F(Builder, nobody_waits_for_a_sensor_that_has_been_silent_for_a_second) {
  both_deliver_once();
  for (int i = 1; i <= 20; ++i) {
    add(kLeft, i * 50ms, i * 50ms);
    closed(i * 50ms + 49ms);
  }
  add(kLeft, 1050ms, 1050ms);
  EXPECT_THAT(closed(1051ms), ElementsAre(ElementsAre(0)));
}

TEST_F(Builder, a_sensor_of_half_the_rate_is_awaited_every_other_time) {
  FrameSynchronizer mixed;
  mixed.add_sensor(kLeft, 20);
  mixed.add_sensor(kRight, 10);
  const auto add_frame = [&](SensorId sensor, nanoseconds time) {
    wire::FrameHeader header{.sensor = sensor, .capture_time = captured_at(time)};
    mixed.add_frame(header, message_of(header), captured_at(time));
    return mixed.take_closed(captured_at(time)).size();
  };
  add_frame(kLeft, 0ms);
  add_frame(kRight, 0ms);
  EXPECT_EQ(mixed.take_closed(captured_at(60ms)).size(), 1u)
      << "the slow one came late for the set that went without it";
  EXPECT_EQ(add_frame(kRight, 100ms), 0u);
  EXPECT_EQ(add_frame(kLeft, 100ms), 1u);
  EXPECT_EQ(add_frame(kLeft, 150ms), 1u) << "the slow sensor is not due";
  EXPECT_EQ(add_frame(kLeft, 200ms), 0u) << "it is due now";
  EXPECT_EQ(add_frame(kRight, 200ms), 1u);
}

TEST_F(Builder, a_frame_that_comes_after_its_set_closed_travels_with_the_next) {
  both_deliver_once();
  add(kLeft, 50ms, 52ms);
  closed(102ms);
  EXPECT_TRUE(add(kRight, 50ms, 103ms));
  add(kLeft, 100ms, 104ms);
  add(kRight, 100ms, 105ms);
  EXPECT_THAT(closed(105ms), ElementsAre(ElementsAre(0, 1, 1)));
}

TEST_F(Builder, a_sensor_that_always_comes_last_is_in_step_from_its_second_frame_on) {
  for (int i = 0; i < 20; ++i) {
    add(kLeft, i * 50ms, i * 50ms + 1ms);
    const auto early = closed(i * 50ms + 1ms);
    add(kRight, i * 50ms, i * 50ms + 21ms);
    const auto sets = builder.take_closed(captured_at(i * 50ms + 21ms));
    if (i < 2) continue;
    EXPECT_THAT(early, IsEmpty()) << i;
    ASSERT_EQ(sets.size(), 1u) << i;
    for (const auto& frame : sets[0]->frames)
      EXPECT_EQ(frame.header.capture_time, captured_at(i * 50ms));
  }
}

TEST_F(Builder, nobody_waits_for_a_sensor_whose_frames_would_come_too_late_anyway) {
  std::size_t frames = 0;
  for (int i = 0; i < 20; ++i) {
    add(kRight, (i - 4) * 50ms, i * 50ms + 10ms);
    frames += closed(i * 50ms + 10ms).size();
    add(kLeft, i * 50ms, i * 50ms + 1ms + 15ms);
    if (i > 1) {
      EXPECT_FALSE(closed(i * 50ms + 16ms).empty()) << i;
    }
  }
}

TEST_F(Builder, a_sensor_on_the_border_between_two_sets_loses_nothing) {
  both_deliver_once();
  const std::vector<nanoseconds> captures = {76ms,  124ms, 176ms,
                                             224ms, 276ms, 324ms};  // sets 2 2 4 4 6 6
  std::size_t frames = 0;
  for (const auto capture : captures) {
    EXPECT_TRUE(add(kRight, capture, capture));
    for (const auto& set : closed(capture + 60ms)) frames += set.size();
  }
  EXPECT_EQ(frames, captures.size());
}

TEST_F(Builder, a_sensor_that_catches_up_is_back_in_step_at_once) {
  add(kLeft, 0ms, 0ms);
  EXPECT_THAT(closed(0ms), ElementsAre(ElementsAre(0)));
  add(kRight, 0ms, 10ms);  // late: goes into the next set
  add(kLeft, 50ms, 51ms);
  closed(51ms);
  add(kRight, 50ms, 60ms);
  closed(60ms);
  for (int i = 2; i < 5; ++i) {
    add(kLeft, i * 50ms, i * 50ms + 1ms);
    add(kRight, i * 50ms, i * 50ms + 1ms);
    const auto sets = builder.take_closed(captured_at(i * 50ms + 1ms));
    ASSERT_EQ(sets.size(), 1u) << i;
    for (const auto& frame : sets[0]->frames) {
      if (i > 2) {
        EXPECT_EQ(frame.header.capture_time, captured_at(i * 50ms));
      }
    }
  }
}

TEST_F(Builder, what_piled_up_in_a_stalled_network_is_delivered) {
  both_deliver_once();
  for (int i = 1; i <= 3; ++i) {
    add(kLeft, i * 50ms, i * 50ms);
    closed(i * 50ms + 100ms);
  }
  for (int i = 1; i <= 3; ++i) EXPECT_TRUE(add(kRight, i * 50ms, 260ms));
  EXPECT_THAT(closed(400ms), ElementsAre(ElementsAre(1, 1, 1)));
}

TEST_F(Builder, frames_of_a_sensor_that_outruns_its_rate_are_discarded) {
  both_deliver_once();
  int accepted = 0;
  for (int i = 0; i < 100; ++i) accepted += add(kRight, 50ms, 50ms);
  EXPECT_LE(accepted, 1 + int{FrameSynchronizer::kMaxFramesOfSensorInSet});
}

TEST_F(Builder, a_sensor_that_outruns_its_rate_does_not_hurry_the_room) {
  both_deliver_once();
  std::size_t sets = 0;
  for (int ms = 1; ms <= 2'000; ++ms) {
    if (ms % 50 == 0) add(kLeft, ms * 1ms, ms * 1ms);
    if (ms % 5 == 2) add(kRight, ms * 1ms, ms * 1ms);  // ten times its rate
    sets += closed(ms * 1ms).size();
  }
  EXPECT_LE(sets, 45U) << "2 s captured_at 20 a second";
  EXPECT_GE(sets, 35U);
}

constexpr SensorId kThere{2}, kAlsoThere{3};
constexpr std::uint64_t kOtherHub = 7;

class BuilderOfTwoHubs : public Builder {
 protected:
  BuilderOfTwoHubs() {
    builder.add_sensor(kThere, kFps, kOtherHub);
    builder.add_sensor(kAlsoThere, kFps, kOtherHub);
    for (const SensorId sensor : {kLeft, kRight, kThere, kAlsoThere}) add(sensor, 0ms, 0ms);
    closed(0ms);
  }
  void add_last(SensorId sensor, nanoseconds captured, nanoseconds arrived) {
    const wire::FrameHeader header{
        .last = true, .sensor = sensor, .capture_time = captured_at(captured)};
    builder.add_frame(header, message_of(header), captured_at(arrived));
  }
};

TEST_F(BuilderOfTwoHubs, nobody_is_waited_for_whom_the_other_hub_has_waited_for_already) {
  add(kLeft, 50ms, 60ms);
  add(kRight, 50ms, 61ms);
  EXPECT_THAT(closed(62ms), IsEmpty());
  add_last(kThere, 50ms, 63ms);
  EXPECT_THAT(closed(63ms), ElementsAre(ElementsAre(0, 1, 2)));
}

TEST_F(BuilderOfTwoHubs, sensors_here_are_still_waited_for) {
  add(kLeft, 50ms, 60ms);
  add(kThere, 50ms, 62ms);
  add_last(kAlsoThere, 50ms, 62ms);
  EXPECT_THAT(closed(62ms), IsEmpty());
  add(kRight, 50ms, 70ms);
  EXPECT_THAT(closed(70ms), ElementsAre(ElementsAre(0, 1, 2, 3)));
}

TEST_F(BuilderOfTwoHubs, what_a_sensor_here_calls_the_last_is_nothing_to_go_by) {
  add_last(kLeft, 50ms, 60ms);
  add_last(kThere, 50ms, 60ms);
  EXPECT_THAT(closed(61ms), IsEmpty()) << "the right one is still to come";
}

TEST_F(BuilderOfTwoHubs, a_late_frame_closes_the_set_with_which_it_travels) {
  add(kLeft, 50ms, 60ms);
  add(kRight, 50ms, 60ms);
  add_last(kThere, 50ms, 60ms);
  EXPECT_THAT(closed(60ms), ElementsAre(ElementsAre(0, 1, 2)));
  add(kLeft, 100ms, 110ms);
  add(kRight, 100ms, 110ms);
  add(kThere, 100ms, 110ms);
  add_last(kAlsoThere, 51ms, 110ms);
  EXPECT_THAT(closed(110ms), ElementsAre(ElementsAre(0, 1, 2, 3)));
}

TEST_F(Builder, set_ids_grow_by_one_and_are_stamped_into_the_messages) {
  for (int i = 0; i < 3; ++i) {
    add(kLeft, i * 50ms, i * 50ms);
    add(kRight, i * 50ms, i * 50ms);
  }
  const auto sets = builder.take_closed(captured_at(1s));
  ASSERT_EQ(sets.size(), 3u);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    EXPECT_EQ(sets[i]->id.value, i + 1);
    for (const auto& frame : sets[i]->frames) {
      const auto header = wire::parse_frame(frame.message->payload());
      ASSERT_TRUE(header.ok());
      EXPECT_EQ(header->set, sets[i]->id);
      EXPECT_EQ(header->last, &frame == &sets[i]->frames.back());
    }
  }
}

TEST_F(Builder, another_room_rate_closes_what_waits_and_goes_on) {
  both_deliver_once();
  add(kLeft, 50ms, 52ms);
  builder.add_sensor(SensorId{2}, 60);
  EXPECT_EQ(builder.fps(), 60);
  EXPECT_THAT(closed(53ms), ElementsAre(ElementsAre(0)));
  EXPECT_TRUE(add(kRight, 54ms, 56ms));
  EXPECT_THAT(closed(200ms), ElementsAre(ElementsAre(1)));
}

TEST_F(Builder, waiting_sets_are_bounded) {
  both_deliver_once();
  for (int i = 1; i <= 100; ++i)
    add(kLeft, i * 50ms, 10ms);  // no frame of the right sensor, and no time passes
  EXPECT_GE(builder.take_closed(captured_at(10ms)).size(), 100 - FrameSynchronizer::kMaxOpenSets);
}

TEST_F(Builder, without_sensors_there_is_no_rate) {
  builder.remove_sensor(kLeft);
  builder.remove_sensor(kRight);
  EXPECT_EQ(builder.fps(), 0);
}

}  // namespace
}  // namespace roomcast::hub
