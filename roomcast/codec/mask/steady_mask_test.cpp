// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/mask/steady_mask.h"

#include <string>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

/// The steady mask of one pixel, frame by frame. Input: '1' seen, '0' not seen, '.' without a
/// reading.
std::string shown(const std::string& frames) {
  SteadyMask steady;
  std::string out;
  for (const char frame : frames) {
    const MaskImage seen(1, 1, frame == '1' ? 255 : 0);
    const DepthImage depth(1, 1, frame == '.' ? 0 : 1000);
    out += steady.update(seen, depth).at(0, 0) ? '1' : '0';
  }
  return out;
}

TEST(SteadyMask, lasting_changes_are_shown_after_four_frames_and_hidden_after_six) {
  EXPECT_EQ(shown("1111"), "1111");
  EXPECT_EQ(shown("0000"), "0000");
  EXPECT_EQ(shown("011111"), "000011");
  EXPECT_EQ(shown("10000000"), "11111100");
}

TEST(SteadyMask, noise_of_single_frames_changes_nothing) {
  EXPECT_EQ(shown("111011011111011101"), std::string(18, '1'));
}

TEST(SteadyMask, hiding_takes_twice_as_long_after_each_change) {
  EXPECT_EQ(shown("1000000"
                  "1111"
                  "000000000000000000000000"
                  "1111"),
            "1111110"
            "0001"
            "111111111111111111111110"
            "0001");
}

TEST(SteadyMask, the_last_value_stays_while_there_is_no_reading) {
  EXPECT_EQ(shown("1..1"), "1111");
  EXPECT_EQ(shown("0..0"), "0000");
}

TEST(SteadyMask, a_calm_pixel_changes_sooner_again) {
  const std::string restless = "10000001111", calm(122, '1'), hidden(12, '0');
  EXPECT_EQ(shown(restless + hidden).back(), '1');
  EXPECT_EQ(shown(restless + calm + hidden).back(), '0');
}

TEST(SteadyMask, however_restless_it_hides_after_a_second_and_shows_after_four_frames) {
  std::string restless;
  for (int i = 0; i < 400; ++i) restless += i / 40 % 2 ? '1' : '0';
  EXPECT_EQ(shown(restless + std::string(32, '0')).back(), '0');
  EXPECT_EQ(shown(restless + std::string(32, '0') + "1111").back(), '1');
}

}  // namespace
}  // namespace roomcast::codec
