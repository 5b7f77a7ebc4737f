// SPDX-License-Identifier: Apache-2.0
// What the other sensors of a room do to a simulated sensor.
#include "roomcast/simulator/sensing/mutual_interference.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/simulator/simulated_sensor.h"

namespace roomcast::simulator {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

std::shared_ptr<const SimulatedRoom> shared_room() {
  static const auto room = SimulatedRoom::build("corners", 1).value();
  return room;
}

SimulatedSensor::Options exposed(Harshness harsh, int sensors, bool mutual) {
  SimulatedSensor::Options options;
  options.count = sensors;
  options.speed = 0;
  options.sensing.half_color = true;
  options.sensing.harsh = harsh;
  options.sensing.mutual_interference = mutual;
  options.timing = TimingOptions::perfect();
  return options;
}

std::vector<DepthImage> frames_of(const SimulatedSensor::Options& options, nanoseconds apart,
                                  int count) {
  const auto sensor = SimulatedSensor::open(shared_room(), options).value();
  auto moment = sensor->make_moment();
  std::vector<DepthImage> frames(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    sensor->look(i * apart, moment);
    sensor->read_depth(static_cast<std::uint64_t>(i), moment, frames[static_cast<std::size_t>(i)]);
  }
  return frames;
}

double readings(const DepthImage& frame) {
  double count = 0;
  for (std::size_t i = 0; i < frame.view().pixel_count(); ++i) count += frame.data()[i] != 0;
  return count;
}

/// Pixels with a reading in just one of two frames, as a share of those with any.
double flickering(const DepthImage& a, const DepthImage& b) {
  double changed = 0, seen = 0;
  for (std::size_t i = 0; i < a.view().pixel_count(); ++i) {
    seen += a.data()[i] != 0 || b.data()[i] != 0;
    changed += (a.data()[i] != 0) != (b.data()[i] != 0);
  }
  return changed / seen;
}

TEST(MutualInterferenceTest, a_sensor_alone_is_not_disturbed) {
  const auto alone = frames_of(exposed(Harshness::kStructuredLight, 1, true), {}, 1);
  EXPECT_EQ(alone[0], frames_of(exposed(Harshness::kStructuredLight, 1, false), {}, 1)[0]);
}

TEST(MutualInterferenceTest, overlapping_patterns_cost_readings_that_come_and_go) {
  const auto without =
      frames_of(exposed(Harshness::kStructuredLight, 4, false), milliseconds(33), 2);
  const auto with = frames_of(exposed(Harshness::kStructuredLight, 4, true), milliseconds(33), 2);
  EXPECT_LT(readings(with[0]), 0.99 * readings(without[0]));
  EXPECT_GT(readings(with[0]), 0.7 * readings(without[0]));
  EXPECT_GT(flickering(with[0], with[1]), 1.5 * flickering(without[0], without[1]));
}

TEST(MutualInterferenceTest, pulses_at_the_same_time_disturb_and_those_in_turns_do_not) {
  auto options = exposed(Harshness::kTimeOfFlight, 4, true);
  const auto undisturbed = frames_of(exposed(Harshness::kTimeOfFlight, 4, false), {}, 1);
  EXPECT_LT(readings(frames_of(options, {}, 1)[0]), 0.99 * readings(undisturbed[0]));
  // In between the pulses of the others, which are all at the same instants.
  const auto sensor = SimulatedSensor::open(shared_room(), options).value();
  auto moment = sensor->make_moment();
  DepthImage in_turn;
  sensor->look(std::chrono::microseconds(160), moment);
  sensor->read_depth(0, moment, in_turn);
  EXPECT_EQ(in_turn, undisturbed[0]);
}

TEST(MutualInterferenceTest, unsynchronised_bursts_come_and_go) {
  auto options = exposed(Harshness::kTimeOfFlight, 4, true);
  options.timing = {};
  options.timing.rate_ppm = 40;
  const auto frames = frames_of(options, seconds(2), 40);
  const auto quiet = frames_of(exposed(Harshness::kTimeOfFlight, 4, false), seconds(2), 40);
  int disturbed = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) disturbed += frames[i] != quiet[i];
  EXPECT_GT(disturbed, 0);
  EXPECT_LT(disturbed, 40);
}

TEST(MutualInterferenceTest, only_sensors_of_one_kind_disturb_each_other) {
  using enum DepthPrinciple;
  EXPECT_TRUE(disturbs(kTimeOfFlight, kTimeOfFlight));
  EXPECT_TRUE(disturbs(kStructuredLight, kStructuredLight));
  EXPECT_FALSE(disturbs(kTimeOfFlight, kStructuredLight));
  EXPECT_FALSE(disturbs(kStereo, kStereo));
}

}  // namespace
}  // namespace roomcast::simulator
