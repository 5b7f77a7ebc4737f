// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/mask/steady_mask.h"

#include <string>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

/// One pixel: '1' seen, '0' not seen, '.' without a reading; what the steady mask shows of it.
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

TEST(SteadyMask, what_does_not_flicker_passes_at_once) {
  EXPECT_EQ(shown("1111"), "1111");
  EXPECT_EQ(shown("0000"), "0000");
  EXPECT_EQ(shown("0111"), "0111");
  EXPECT_EQ(shown("1000"), "1000");
}

TEST(SteadyMask, a_return_takes_twice_as_long_each_time) {
  EXPECT_EQ(shown("1011011111"), "1001000011");
}

TEST(SteadyMask, what_was_known_stays_while_there_is_no_reading) {
  EXPECT_EQ(shown("1..1"), "1111");
  EXPECT_EQ(shown("0..0"), "0000");
}

TEST(SteadyMask, a_calm_pixel_starts_anew) {
  const std::string calm(100, '1');
  EXPECT_EQ(shown("101" + calm + "01").substr(3 + calm.size()), "01");
}

TEST(SteadyMask, flicker_for_ever_returns_twice_a_second_at_most) {
  std::string flicker;  // of ten seconds
  for (int i = 0; i < 300; ++i) flicker += i % 17 == 0 ? '0' : '1';
  const std::string steady = shown(flicker);
  int returns = 0;
  for (std::size_t i = 1; i < steady.size(); ++i) returns += steady[i] > steady[i - 1];
  EXPECT_LE(returns, 20);
  EXPECT_GT(returns, 10);
}

}  // namespace
}  // namespace roomcast::codec
