// SPDX-License-Identifier: Apache-2.0
// What a harsh sensor reports of a room, against the truth.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/simulator/simulated_sensor.h"

namespace roomcast::simulator {
namespace {

std::shared_ptr<const SimulatedRoom> harsh_room() {
  static const auto room = SimulatedRoom::build("desk-rows", 1).value();
  return room;
}

std::unique_ptr<SimulatedSensor> harsh_sensor(Harshness harshness, std::uint64_t seed) {
  SimulatedSensor::Options options;
  options.seed = seed;
  options.sensing.half_color = true;
  options.sensing.harsh = harshness;
  return SimulatedSensor::open(harsh_room(), options).value();
}

struct HarshReadings {
  std::vector<double> ratios;   // true depth over reading
  std::set<std::uint16_t> far;  // different readings beyond 3 m
  double lost = 0;              // share of the pixels
};

HarshReadings harsh_readings_of(const SimulatedSensor& sensor) {
  auto moment = sensor.make_moment();
  sensor.look({}, moment);
  DepthImage depth_mm;
  sensor.read_depth(0, moment, depth_mm);
  const DepthImage& clean_mm = sensor.clean_depth_mm(moment);
  HarshReadings readings;
  for (std::size_t i = 0; i < depth_mm.view().pixel_count(); ++i) {
    const std::uint16_t reading = depth_mm.data()[i];
    readings.lost += reading == 0;
    if (reading == 0) continue;
    readings.ratios.push_back(clean_mm.data()[i] / static_cast<double>(reading));
    if (reading > 3000) readings.far.insert(reading);
  }
  readings.lost /= static_cast<double>(depth_mm.view().pixel_count());
  std::ranges::sort(readings.ratios);
  return readings;
}

TEST(HarshSensor, readings_are_off_by_the_depth_scale_of_the_truth) {
  for (const Harshness harshness : {Harshness::kTimeOfFlight, Harshness::kStructuredLight}) {
    for (const std::uint64_t seed : {1U, 2U}) {
      const auto sensor = harsh_sensor(harshness, seed);
      const HarshReadings readings = harsh_readings_of(*sensor);
      ASSERT_GT(readings.ratios.size(), 20'000U);
      EXPECT_NEAR(readings.ratios[readings.ratios.size() / 2], sensor->unit().depth_scale, 0.012)
          << name_of(harshness) << " " << seed;
      EXPECT_GT(readings.lost, 0.02);
      EXPECT_LT(readings.lost, 0.8);
    }
  }
}

TEST(HarshSensor, structured_light_has_steps_and_time_of_flight_none) {
  const HarshReadings steps = harsh_readings_of(*harsh_sensor(Harshness::kStructuredLight, 1));
  const HarshReadings smooth = harsh_readings_of(*harsh_sensor(Harshness::kTimeOfFlight, 1));
  EXPECT_LT(steps.far.size(), 80U);  // 3 to 8 m are about 70 steps
  EXPECT_GT(smooth.far.size(), 500U);
}

/// A sensor that does, or does not, register its colour.
std::unique_ptr<SimulatedSensor> sensor_that_registers(bool registers) {
  for (std::uint64_t seed = 1; seed < 40; ++seed) {
    SensingOptions options;
    options.harsh = Harshness::kStructuredLight;
    if (make_unit(options, seed, 0).registered_by.has_value() == registers)
      return harsh_sensor(Harshness::kStructuredLight, seed);
  }
  return nullptr;
}

TEST(HarshSensor, registered_colour_has_depths_grid_and_its_holes) {
  const auto sensor = sensor_that_registers(true);
  ASSERT_TRUE(sensor);
  auto moment = sensor->make_moment();
  sensor->look({}, moment);
  DepthImage depth_mm;
  ColorImage color;
  sensor->read_depth(0, moment, depth_mm);
  sensor->read_color(0, 1.0F, moment, color);
  ASSERT_TRUE(same_size(color.view(), depth_mm.view()));
  EXPECT_TRUE(sensor->calibration().color_is_registered);
  std::size_t colored = 0, readings = 0;
  for (std::size_t i = 0; i < depth_mm.view().pixel_count(); ++i) {
    const Rgb8 pixel = color.data()[i];
    const bool black = pixel.r == 0 && pixel.g == 0 && pixel.b == 0;
    readings += depth_mm.data()[i] != 0;
    colored += !black;
    if (depth_mm.data()[i] == 0) {
      ASSERT_TRUE(black);
    }
  }
  EXPECT_GT(colored, readings / 2);
}

TEST(HarshSensor, exposure_drifts_between_frames_of_the_same_light) {
  const auto sensor = sensor_that_registers(false);
  ASSERT_TRUE(sensor);
  const auto early = sensor->color_gains(1.0F, {});
  const auto late = sensor->color_gains(1.0F, std::chrono::seconds(3));
  EXPECT_NE(early, late);
}

TEST(HarshSensor, the_same_frame_is_the_same_in_any_order) {
  const auto sensor = harsh_sensor(Harshness::kMixed, 3);
  const auto frame_of = [&](SimulatedSensor::Moment& moment) {
    sensor->look(std::chrono::milliseconds(400), moment);
    std::pair<DepthImage, ColorImage> frame;
    sensor->read_depth(4, moment, frame.first);
    sensor->read_color(4, 1.0F, moment, frame.second);
    return frame;
  };
  auto fresh = sensor->make_moment(), used = sensor->make_moment();
  sensor->look(std::chrono::seconds(9), used);
  const auto one = frame_of(fresh), two = frame_of(used);
  EXPECT_EQ(one.first, two.first);
  EXPECT_TRUE(std::equal(
      one.second.data(), one.second.data() + one.second.view().pixel_count(), two.second.data(),
      [](const Rgb8& a, const Rgb8& b) { return a.r == b.r && a.g == b.g && a.b == b.b; }));
}

}  // namespace
}  // namespace roomcast::simulator
