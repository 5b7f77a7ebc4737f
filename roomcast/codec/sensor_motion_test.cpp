// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/sensor_motion.h"

#include <algorithm>
#include <random>
#include <vector>

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

/// The view of a structured-light sensor 2 m to 5 m from a floor. Its noise grows with the square
/// of the distance and is shared by the pixels of a block.
class RoughSensor {
 public:
  static constexpr int kWidth = 320, kHeight = 240;
  /// From `nearer_mm` nearer; with a person at 1 m over the first `covered` columns, who walks.
  DepthImage reading(double nearer_mm, int covered = 0) {
    std::normal_distribution<double> gauss;
    DepthImage depth(kWidth, kHeight);
    std::vector<double> shared(static_cast<std::size_t>(kWidth / 8));
    walked_mm_ += 15;
    for (int y = 0; y < kHeight; ++y) {
      if (y % 8 == 0) std::generate(shared.begin(), shared.end(), [&] { return gauss(random_); });
      for (int x = 0; x < kWidth; ++x) {
        const double z =
            (x < covered ? 1.5 + 0.001 * walked_mm_ : 2 + 3.0 * y / kHeight) - nearer_mm / 1000;
        const double noise = 0.8 * shared[static_cast<std::size_t>(x / 8)] + 1.2 * gauss(random_);
        depth.at(x, y) = static_cast<std::uint16_t>(1000 * z + noise * z * z);
      }
    }
    return depth;
  }

 private:
  std::mt19937 random_{11};
  double walked_mm_ = 0;
};

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
    EXPECT_FALSE(motion.update(sensor.reading(0, RoughSensor::kWidth / 2))) << i;
  }
}

TEST(SensorMotion, without_readings_there_is_none) {
  SensorMotion motion;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(motion.update(DepthImage(128, 96)));
}

}  // namespace
}  // namespace roomcast::codec
