// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/sensor_motion.h"

#include <gtest/gtest.h>

#include "roomcast/codec/testing/rough_sensor.h"
#include "roomcast/codec/testing/synthetic_motion.h"

namespace roomcast::codec {
namespace {

/// At 0.3 m/s, 30 frames a second.
DepthImage nearer_by(int frames) {
  return SyntheticMotion().reading_from_nearer(10 * frames);
}

TEST(SensorMotion, a_carried_sensor_moves_within_an_eighth_of_a_second_and_a_little) {
  SensorMotion motion;
  for (int i = 0; i < 12; ++i) EXPECT_EQ(motion.update(nearer_by(i)), i >= 6) << i;
}

TEST(SensorMotion, stops_half_a_second_after_the_last_motion) {
  SensorMotion motion;
  for (int i = 0; i < 12; ++i) (void)motion.update(nearer_by(i));
  for (int i = 0; i < 20; ++i) EXPECT_EQ(motion.update(nearer_by(11)), i < 13) << i;
}

TEST(SensorMotion, noise_and_objects_crossing_the_view_are_no_motion) {
  SensorMotion motion;
  const SyntheticMotion room;
  for (int i = 0; i < 60; ++i) EXPECT_FALSE(motion.update(room.reading(i))) << i;
}

TEST(SensorMotion, noise_of_a_fixed_structured_light_sensor_is_no_motion) {
  SensorMotion motion;
  RoughSensor sensor;
  for (int i = 0; i < 90; ++i) EXPECT_FALSE(motion.update(sensor.reading(0))) << i;
}

TEST(SensorMotion, such_a_sensor_that_is_picked_up_moves_within_six_frames) {
  constexpr int kStill = 45, kWithin = 6;
  SensorMotion motion;
  RoughSensor sensor;
  for (int i = 0; i < kStill; ++i) EXPECT_FALSE(motion.update(sensor.reading(0))) << i;
  for (int i = 1; i <= 20; ++i) {
    const bool moves = motion.update(sensor.reading(12 * i));
    if (i >= kWithin) {
      EXPECT_TRUE(moves) << i;
    }
  }
}

TEST(SensorMotion, a_person_who_fills_half_of_the_view_is_no_motion) {
  SensorMotion motion;
  RoughSensor sensor;
  for (int i = 0; i < 30; ++i) EXPECT_FALSE(motion.update(sensor.reading(0))) << i;
  for (int i = 0; i < 60; ++i) {
    EXPECT_FALSE(motion.update(sensor.reading(0, sensor.width / 2))) << i;
  }
}

/// People take two fifths of every region, and each is elsewhere in every frame.
DepthImage with_people_everywhere(DepthImage reading, int frame) {
  constexpr int kEvery = 40, kWide = 16;
  for (int y = 0; y < reading.height(); ++y) {
    for (int x = 0; x < reading.width(); ++x) {
      if (x % kEvery < kWide)
        reading.at(x, y) = static_cast<std::uint16_t>(1'500 + 100 * (frame % 7) + x);
    }
  }
  return reading;
}

TEST(SensorMotion, people_in_all_parts_of_the_view_who_move_much_between_frames_are_no_motion) {
  SensorMotion motion;
  RoughSensor sensor;
  for (int i = 0; i < 60; ++i) {
    EXPECT_FALSE(motion.update(with_people_everywhere(sensor.reading(0), i))) << i;
  }
  bool moves = false;
  for (int i = 1; i <= 12; ++i)
    moves = motion.update(with_people_everywhere(sensor.reading(12 * i), i));
  EXPECT_TRUE(moves) << "the walls move, too";
}

TEST(SensorMotion, without_readings_there_is_none) {
  SensorMotion motion;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(motion.update(DepthImage(128, 96)));
}

}  // namespace
}  // namespace roomcast::codec
