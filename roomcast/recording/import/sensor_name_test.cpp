// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/sensor_name.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

TEST(SensorName, is_legal_as_a_folder) {
  EXPECT_EQ(sensor_name("001514394512", "x"), "001514394512");
  EXPECT_EQ(sensor_name("/camera/left image", "x"), "camera-left-image");
  EXPECT_EQ(sensor_name("../..", "some where/take 1.mkv"), "take-1");
  EXPECT_EQ(sensor_name("\n\x1b", ""), "sensor");
  EXPECT_EQ(sensor_name(std::string(1000, 'a'), "").size(), 48U);
}

TEST(SensorName, a_second_one_gets_a_number) {
  std::vector<std::string> names = {"a", "b", "a", "a-2", "a"};
  make_unique(names);
  EXPECT_THAT(names, testing::ElementsAre("a", "b", "a-2", "a-2-2", "a-3"));
}

}  // namespace
}  // namespace roomcast::recording
