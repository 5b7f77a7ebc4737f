// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/voices/voice_mix.h"

#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

class VoiceMixTest : public testing::Test {
 protected:
  VoiceMix mix(int channels) {
    return {
        channels,
        {.sound =
             [this](std::span<const float> s) { heard.insert(heard.end(), s.begin(), s.end()); },
         .silence =
             [this](std::int64_t samples) {
               heard.resize(heard.size() + static_cast<std::size_t>(samples));
               ++silences;
             }}};
  }
  std::vector<float> heard;
  int silences = 0;
};

TEST_F(VoiceMixTest, pieces_are_summed_at_their_places) {
  auto mixed = mix(1);
  mixed.add(2000, std::vector<float>{1, 2, 3}, {1, 0});
  mixed.add(958, std::vector<float>{1, 1, 1}, {0.5F, 0});  // over the border of two blocks
  mixed.add(2001, std::vector<float>{10, 10}, {1, 0});
  mixed.finish(2500);
  ASSERT_EQ(heard.size(), 2500u);
  std::vector<float> expected(2500);
  expected[958] = expected[959] = expected[960] = 0.5F;
  expected[2000] = 1;
  expected[2001] = 12;
  expected[2002] = 13;
  EXPECT_EQ(heard, expected);
}

TEST_F(VoiceMixTest, channels_have_their_own_loudness) {
  auto mixed = mix(2);
  mixed.add(1, std::vector<float>{1}, {0.25F, 0.75F});
  mixed.finish(3);
  EXPECT_EQ(heard, (std::vector<float>{0, 0, 0.25F, 0.75F, 0, 0}));
}

TEST_F(VoiceMixTest, what_was_given_back_is_not_given_again) {
  auto mixed = mix(1);
  mixed.add(0, std::vector<float>{1}, {1, 0});
  mixed.give_until(960 * 3 + 5);
  EXPECT_EQ(heard.size(), 960u * 3);
  mixed.add(100, std::vector<float>(960 * 3, 1.F), {1, 0});  // begins too early
  mixed.finish(960 * 4);
  ASSERT_EQ(heard.size(), 960u * 4);
  EXPECT_EQ(heard[100], 0);
  EXPECT_EQ(heard[960 * 3], 1);
}

TEST_F(VoiceMixTest, a_long_silence_is_one_piece) {
  auto mixed = mix(1);
  mixed.give_until(960'000);
  EXPECT_EQ(silences, 1);
  mixed.finish(960'100);
  EXPECT_EQ(heard.size(), 960'100u);
}

}  // namespace
}  // namespace roomcast::recording
