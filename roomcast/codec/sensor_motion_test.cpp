// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/sensor_motion.h"

#include <gtest/gtest.h>

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

TEST(SensorMotion, without_readings_there_is_none) {
  SensorMotion motion;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(motion.update(DepthImage(128, 96)));
}

}  // namespace
}  // namespace roomcast::codec
