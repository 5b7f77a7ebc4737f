// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/simulated_sensor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

/// Half-size colour, which these tests do not examine.
SimulatedSensor::Options small(int index, std::uint64_t seed = 1) {
  SimulatedSensor::Options options;
  options.index = index;
  options.seed = seed;
  options.sensing.half_color = true;
  return options;
}

std::shared_ptr<const SimulatedRoom> office() {
  static const auto room = SimulatedRoom::build("office", 1).value();
  return room;
}

/// Shared by all read-only tests, because opening a sensor is slow.
const SimulatedSensor& first_in_office() {
  static const auto sensor = SimulatedSensor::open(office(), small(0)).value();
  return *sensor;
}

struct Pictures {
  DepthImage clean_mm, depth_mm;
  ColorImage color;
};

Pictures pictures(const SimulatedSensor& sensor, SimulatedSensor::Moment& moment, nanoseconds time,
                  std::uint64_t frame) {
  Pictures seen;
  sensor.look(time, moment);
  seen.clean_mm = sensor.clean_depth_mm(moment);
  sensor.read_depth(frame, moment, seen.depth_mm);
  sensor.read_color(frame, 1.0F, moment, seen.color);
  return seen;
}

Pictures pictures(const SimulatedSensor& sensor, nanoseconds time, std::uint64_t frame) {
  auto moment = sensor.make_moment();
  return pictures(sensor, moment, time, frame);
}

TEST(SimulatedSensor, same_seed_and_frame_give_the_same_bits_in_any_order) {
  const auto first = SimulatedSensor::open(office(), small(1, 42)).value();
  auto options = small(1, 42);
  options.workers = 1;
  const auto second = SimulatedSensor::open(office(), options).value();
  auto used = second->make_moment();
  for (int i = 0; i < 4; ++i) pictures(*second, used, milliseconds(300 * i), 8);
  const Pictures a = pictures(*first, milliseconds(1234), 5);
  const Pictures b = pictures(*second, used, milliseconds(1234), 5);
  EXPECT_EQ(a.clean_mm, b.clean_mm);
  EXPECT_EQ(a.depth_mm, b.depth_mm);
  EXPECT_EQ(a.color, b.color);
}

TEST(SimulatedSensor, noise_differs_between_frames_and_the_truth_does_not) {
  const Pictures first = pictures(first_in_office(), milliseconds(500), 1);
  const Pictures second = pictures(first_in_office(), milliseconds(500), 2);
  EXPECT_NE(first.depth_mm, second.depth_mm);
  EXPECT_NE(first.color, second.color);
  EXPECT_EQ(first.clean_mm, second.clean_mm);
}

TEST(SimulatedSensor, the_truth_changes_where_something_moves_only) {
  const SimulatedSensor& sensor = first_in_office();
  auto moment = sensor.make_moment();
  MaskImage moving_before, moving;
  const DepthImage before = pictures(sensor, moment, milliseconds(0), 0).clean_mm;
  sensor.mark_moving(moment, moving_before);
  int changed = 0;
  for (int step = 1; step <= 7; ++step) {
    const DepthImage after = pictures(sensor, moment, milliseconds(1000 * step - 100), 0).clean_mm;
    sensor.mark_moving(moment, moving);
    for (std::size_t i = 0; i < after.view().pixel_count(); ++i) {
      if (after.data()[i] == before.data()[i]) continue;
      ++changed;
      EXPECT_TRUE(moving.data()[i] == 255 || moving_before.data()[i] == 255);
    }
  }
  EXPECT_GT(changed, 2000);
}

TEST(SimulatedSensor, at_speed_0_nothing_moves) {
  auto options = small(0);
  options.speed = 0;
  const auto sensor = SimulatedSensor::open(office(), options).value();
  EXPECT_EQ(pictures(*sensor, milliseconds(0), 0).clean_mm,
            pictures(*sensor, milliseconds(2000), 0).clean_mm);
}

TEST(SimulatedSensor, a_clean_sensor_reports_the_truth_in_even_colours) {
  auto options = small(1);
  options.sensing = options.sensing.clean();
  const auto sensor = SimulatedSensor::open(office(), options).value();
  auto moment = sensor->make_moment();
  const Pictures seen = pictures(*sensor, moment, milliseconds(700), 3);
  EXPECT_EQ(seen.depth_mm, seen.clean_mm);
  ColorImage clean;
  sensor->clean_color(1.0F, moment, clean);
  EXPECT_EQ(seen.color, clean);
  EXPECT_EQ(sensor->calibration().depth, sensor->exact_calibration().depth);
  EXPECT_EQ(sensor->calibration().color, sensor->exact_calibration().color);
}

struct Errors {
  double missing, outliers, rms_mm;
};

Errors errors_of(const Pictures& seen, int outlier_mm) {
  double missing = 0, outliers = 0, squares = 0, count = 0;
  for (std::size_t i = 0; i < seen.clean_mm.view().pixel_count(); ++i) {
    const int error_mm = seen.depth_mm.data()[i] - seen.clean_mm.data()[i];
    if (seen.depth_mm.data()[i] == 0) {
      ++missing;
    } else if (std::abs(error_mm) > outlier_mm) {
      ++outliers;
    } else {
      squares += error_mm * error_mm;
      ++count;
    }
  }
  const auto all = static_cast<double>(seen.clean_mm.view().pixel_count());
  return {missing / all, outliers / all, std::sqrt(squares / count)};
}

TEST(SimulatedSensor, noisy_depth_stays_near_the_truth_with_few_holes_for_every_camera) {
  for (const auto model : {simulator::CameraModel::kKinect2, simulator::CameraModel::kAzure,
                           simulator::CameraModel::kD435}) {
    auto options = small(1);
    options.sensing.camera = model;
    const auto sensor = SimulatedSensor::open(office(), options).value();
    const bool stereo = model == simulator::CameraModel::kD435;  // sigma is 60 mm at 4 m
    const Errors errors = errors_of(pictures(*sensor, milliseconds(700), 3), stereo ? 300 : 50);
    EXPECT_GT(errors.missing, 0.003) << simulator::name_of(model);
    // The office is 8 m long; the Azure Kinect's range is 5.5 m.
    const bool short_sighted = model == simulator::CameraModel::kAzure;
    EXPECT_LT(errors.missing, short_sighted ? 0.4 : 0.15) << simulator::name_of(model);
    EXPECT_GT(errors.outliers, 0.0005) << simulator::name_of(model);
    EXPECT_LT(errors.outliers, 0.06) << simulator::name_of(model);
    EXPECT_GT(errors.rms_mm, 1.5) << simulator::name_of(model);
    EXPECT_LT(errors.rms_mm, stereo ? 90.0 : 16.0) << simulator::name_of(model);
    RecordProperty(std::string(simulator::name_of(model)) + "_rms_um",
                   static_cast<int>(1000 * errors.rms_mm));
    RecordProperty(std::string(simulator::name_of(model)) + "_outliers_ppm",
                   static_cast<int>(1e6 * errors.outliers));
  }
}

TEST(SimulatedSensor, pictures_have_the_calibrations_sizes) {
  const SensorCalibration& lenses = first_in_office().calibration();
  const Pictures seen = pictures(first_in_office(), milliseconds(0), 0);
  EXPECT_TRUE(same_size(seen.depth_mm.view(), lenses.depth));
  EXPECT_TRUE(same_size(seen.color.view(), lenses.color));
  EXPECT_EQ(lenses.depth.width, 512);
  EXPECT_EQ(lenses.color.width, 960);  // half of 1920
  EXPECT_TRUE(lenses.depth.check().ok());
  EXPECT_TRUE(lenses.color.check().ok());
}

TEST(SimulatedSensor, sensors_out_of_range_are_refused) {
  for (const auto& [index, count] : {std::pair{3, 3}, {-1, 3}, {0, 0}, {0, 9}}) {
    auto options = small(index);
    options.count = count;
    const auto sensor = SimulatedSensor::open(office(), options);
    ASSERT_FALSE(sensor);
    EXPECT_EQ(sensor.error().code, ErrorCode::kInvalidArgument);
  }
  EXPECT_THAT(SimulatedSensor::open(office(), small(3)).error().message, HasSubstr("s0 to s2"));
}

}  // namespace
}  // namespace roomcast::simulator
