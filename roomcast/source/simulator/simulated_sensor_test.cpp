// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/simulated_sensor.h"

#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

struct Pictures {
  DepthImage depth_mm;
  ColorImage color;
};

Pictures render(SimulatedSensor& sensor, nanoseconds time, std::uint64_t index, bool with_noise) {
  Pictures pictures;
  sensor.render(time, index, pictures.depth_mm, pictures.color, with_noise);
  return pictures;
}

TEST(SimulatedSensor, same_seed_and_frame_give_the_same_bits) {
  const SimulatedSensor::Options options{"", 1, 3, 42};
  auto first = SimulatedSensor::open(options).value();
  auto second = SimulatedSensor::open(options).value();
  render(*second, milliseconds(900), 8, true);  // what came before does not matter
  const Pictures a = render(*first, milliseconds(1234), 5, true);
  const Pictures b = render(*second, milliseconds(1234), 5, true);
  EXPECT_EQ(a.depth_mm, b.depth_mm);
  EXPECT_EQ(a.color, b.color);
}

TEST(SimulatedSensor, noise_differs_between_frames_and_seeds_but_the_truth_does_not) {
  auto sensor = SimulatedSensor::open({"", 0, 3, 1}).value();
  auto other_seed = SimulatedSensor::open({"", 0, 3, 2}).value();
  const auto at = milliseconds(500);
  EXPECT_NE(render(*sensor, at, 1, true).depth_mm, render(*sensor, at, 2, true).depth_mm);
  EXPECT_NE(render(*sensor, at, 1, true).depth_mm, render(*other_seed, at, 1, true).depth_mm);
  EXPECT_EQ(render(*sensor, at, 1, false).depth_mm, render(*sensor, at, 2, false).depth_mm);
  EXPECT_EQ(render(*sensor, at, 1, false).color, render(*sensor, at, 2, false).color);
}

TEST(SimulatedSensor, only_the_person_changes_the_truth_and_does_so_all_the_time) {
  auto sensor = SimulatedSensor::open({"", 2, 3, 1}).value();
  const DepthImage before = render(*sensor, milliseconds(0), 0, false).depth_mm;
  for (int step = 1; step <= 7; ++step) {
    const DepthImage after = render(*sensor, milliseconds(1000 * step - 100), 0, false).depth_mm;
    int changed = 0;
    for (std::size_t i = 0; i < after.view().pixel_count(); ++i)
      changed += after.data()[i] != before.data()[i];
    EXPECT_GT(changed, 2000);
    EXPECT_LT(changed, 70000);
  }
}

TEST(SimulatedSensor, the_person_is_gone_from_where_they_were) {
  auto sensor = SimulatedSensor::open({"", 0, 3, 1}).value();
  const Pictures fresh = render(*sensor, milliseconds(3000), 0, true);
  for (int i = 0; i < 5; ++i) render(*sensor, milliseconds(300 * i), 0, true);
  const Pictures again = render(*sensor, milliseconds(3000), 0, true);
  EXPECT_EQ(fresh.depth_mm, again.depth_mm);
  EXPECT_EQ(fresh.color, again.color);
}

TEST(SimulatedSensor, noisy_depth_stays_near_the_truth_with_few_holes) {
  auto sensor = SimulatedSensor::open({"office", 1, 3, 1}).value();
  const DepthImage truth = render(*sensor, milliseconds(700), 3, false).depth_mm;
  const DepthImage noisy = render(*sensor, milliseconds(700), 3, true).depth_mm;
  double missing = 0, far_off = 0, squares = 0, count = 0;
  for (std::size_t i = 0; i < truth.view().pixel_count(); ++i) {
    if (noisy.data()[i] == 0) {
      ++missing;
      continue;
    }
    const int error_mm = std::abs(noisy.data()[i] - truth.data()[i]);
    if (error_mm > 50) {
      ++far_off;
    } else {
      squares += error_mm * error_mm;
      ++count;
    }
  }
  const auto all = static_cast<double>(truth.view().pixel_count());
  EXPECT_GT(missing / all, 0.005);
  EXPECT_LT(missing / all, 0.12);
  EXPECT_GT(far_off / all, 0.0005);
  EXPECT_LT(far_off / all, 0.03);
  EXPECT_GT(std::sqrt(squares / count), 1.5);
  EXPECT_LT(std::sqrt(squares / count), 12.0);
}

TEST(SimulatedSensor, pictures_have_the_calibrations_sizes) {
  auto sensor = SimulatedSensor::open({}).value();
  const Pictures seen = render(*sensor, milliseconds(0), 0, true);
  EXPECT_TRUE(same_size(seen.depth_mm.view(), DepthView{nullptr, 512, 424, 512}));
  EXPECT_TRUE(same_size(seen.color.view(), ColorView{nullptr, 960, 540, 960}));
  EXPECT_TRUE(sensor->calibration().depth.check().ok());
  EXPECT_TRUE(sensor->calibration().color.check().ok());
}

TEST(SimulatedSensor, sensors_out_of_range_are_refused) {
  for (const auto& [index, count] : {std::pair{3, 3}, {-1, 3}, {0, 0}, {0, 9}}) {
    const auto sensor = SimulatedSensor::open({"", index, count, 1});
    ASSERT_FALSE(sensor);
    EXPECT_EQ(sensor.error().code, ErrorCode::kInvalidArgument);
  }
  EXPECT_THAT(SimulatedSensor::open({"", 3, 3, 1}).error().message, HasSubstr("s0 to s2"));
}

}  // namespace
}  // namespace roomcast
