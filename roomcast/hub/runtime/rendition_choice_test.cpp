// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/rendition_choice.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

constexpr std::size_t kSensors = 4;

class RenditionChoiceTest : public testing::Test {
 protected:
  /// The number of windows until a change, each with so many sets dropped; at most 1000.
  int windows_until_change(double dropped) {
    for (int window = 1; window <= 1000; ++window) {
      choice.dropped(dropped);
      for (int set = 0; set < RenditionChoice::kWindow; ++set) {
        if (choice.offered(kSensors)) return window;
      }
    }
    return 1000;
  }

  static constexpr double kMuch = RenditionChoice::kTooMuch * RenditionChoice::kWindow + 1;
  RenditionChoice choice;
};

TEST_F(RenditionChoiceTest, all_sensors_come_whole_on_a_good_line) {
  EXPECT_EQ(windows_until_change(0), 1000);
  EXPECT_EQ(choice.small_sensors(), 0u);
}

TEST_F(RenditionChoiceTest, a_few_lost_sets_change_nothing) {
  EXPECT_EQ(windows_until_change(1), 1000);
}

TEST_F(RenditionChoiceTest, it_gives_way_by_half_each_window) {
  EXPECT_EQ(windows_until_change(kMuch), 1);
  EXPECT_EQ(choice.small_sensors(), 2u);
  EXPECT_EQ(windows_until_change(kMuch), 1);
  EXPECT_EQ(choice.small_sensors(), 3u);
  EXPECT_EQ(windows_until_change(kMuch), 1);
  EXPECT_EQ(choice.small_sensors(), kSensors);
  EXPECT_EQ(windows_until_change(kMuch), 1000) << "there is nothing smaller";
}

TEST_F(RenditionChoiceTest, on_a_line_that_is_far_too_slow_all_come_small_at_once) {
  EXPECT_EQ(windows_until_change(RenditionChoice::kWindow), 1);
  EXPECT_EQ(choice.small_sensors(), kSensors);
}

TEST_F(RenditionChoiceTest, it_tries_more_after_a_while_and_less_often_after_each_failure) {
  windows_until_change(kMuch);
  int patience = RenditionChoice::kPatience;
  for (int failure = 0; failure < 6; ++failure) {
    EXPECT_EQ(windows_until_change(0), patience) << failure;
    EXPECT_EQ(choice.small_sensors(), 1u);
    windows_until_change(kMuch);
    EXPECT_EQ(choice.small_sensors(), 3u);
    EXPECT_EQ(windows_until_change(0),
              patience = std::min(2 * patience, RenditionChoice::kMaxPatience));
    EXPECT_EQ(choice.small_sensors(), 2u);
    while (choice.small_sensors() > 2) windows_until_change(0);
  }
}

TEST_F(RenditionChoiceTest, on_a_line_that_has_recovered_all_come_whole_again) {
  while (choice.small_sensors() < kSensors) windows_until_change(kMuch);
  while (choice.small_sensors() > 0) EXPECT_LT(windows_until_change(0), 1000);
}

}  // namespace
}  // namespace roomcast::hub
