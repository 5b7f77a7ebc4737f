// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/resampling.h"

#include <gtest/gtest.h>

#include "roomcast/sound/wav_fixture.h"

namespace roomcast::sound {
namespace {

TEST(Resampling, a_tone_stays_as_loud_and_as_high) {
  for (const int from_hz : {8'000, 44'100, 96'000}) {
    const auto samples = resampled(tone(1000, 0.2, 0.5F, from_hz), from_hz, 48'000);
    EXPECT_EQ(samples.size(), 9600u) << from_hz;
    EXPECT_NEAR(amplitude_of(1000, samples), 0.5, 0.01) << from_hz;
  }
}

TEST(Resampling, what_the_new_rate_cannot_hold_is_removed) {
  const auto samples = resampled(tone(20'000, 0.2, 0.5F, 96'000), 96'000, 16'000);
  EXPECT_LT(amplitude_of(4'000, samples, 16'000), 0.005) << "its mirror";
}

TEST(Resampling, the_same_rate_changes_nothing) {
  EXPECT_EQ(resampled({1, 2, 3}, 48'000, 48'000), (std::vector<float>{1, 2, 3}));
}

}  // namespace
}  // namespace roomcast::sound
