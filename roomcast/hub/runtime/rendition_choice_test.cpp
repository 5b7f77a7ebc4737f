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
  EXPECT_EQ(choice.held_back(), 0U) << "not before the small ones were tried";
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

TEST_F(RenditionChoiceTest, where_even_all_small_ones_are_too_much_sensors_are_held_back_but_one) {
  while (choice.small_sensors() < kSensors) windows_until_change(RenditionChoice::kWindow);
  EXPECT_EQ(choice.held_back(), 0U);
  windows_until_change(kMuch);
  EXPECT_EQ(choice.held_back(), 1U);
  windows_until_change(RenditionChoice::kWindow);
  EXPECT_EQ(choice.held_back(), 2U) << "half of those that came";
  windows_until_change(kMuch);
  EXPECT_EQ(choice.held_back(), kSensors - 1);
  EXPECT_EQ(windows_until_change(kMuch), 1000) << "one comes";
  EXPECT_EQ(choice.small_sensors(), kSensors);
}

TEST_F(RenditionChoiceTest, what_is_lost_counts_among_the_sets_that_have_something_for_the_viewer) {
  while (choice.small_sensors() < kSensors) windows_until_change(RenditionChoice::kWindow);
  constexpr int kOneIn = 4;
  int offered = 0, windows = 0;
  while (choice.held_back() == 0 && windows < 100) {
    for (int set = 0; set < RenditionChoice::kWindow; ++set)
      choice.offered(kSensors, ++offered % kOneIn == 0);
    choice.dropped(2);  // half of those with something
    ++windows;
  }
  EXPECT_EQ(choice.held_back(), 1U);
  EXPECT_GE(windows, kOneIn) << "the queue may empty first";
}

TEST_F(RenditionChoiceTest, one_more_is_tried_before_a_larger_picture_is) {
  while (choice.small_sensors() < kSensors) windows_until_change(RenditionChoice::kWindow);
  windows_until_change(kMuch);
  EXPECT_EQ(windows_until_change(0), RenditionChoice::kPatience);
  EXPECT_EQ(choice.held_back(), 0U);
  EXPECT_EQ(choice.small_sensors(), kSensors);
  windows_until_change(kMuch);
  EXPECT_EQ(choice.held_back(), 1U);
  EXPECT_EQ(windows_until_change(0), 2 * RenditionChoice::kPatience) << "it failed before";
}

TEST_F(RenditionChoiceTest, on_a_line_that_has_recovered_all_come_whole_again) {
  while (choice.small_sensors() < kSensors) windows_until_change(kMuch);
  while (choice.small_sensors() > 0) EXPECT_LT(windows_until_change(0), 1000);
}

}  // namespace
}  // namespace roomcast::hub
