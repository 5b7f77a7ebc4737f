// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/voice/played_sound.h"

#include <gtest/gtest.h>

namespace roomcast::viewer {
namespace {

sound::StereoBlock block_of(float left, float right) {
  sound::StereoBlock block{};
  for (std::size_t i = 0; i < block.size(); ++i) block[i] = i % 2 == 0 ? left : right;
  return block;
}

TEST(PlayedSound, is_the_mean_of_left_and_right_in_its_order) {
  PlayedSound played;
  played.push(block_of(1, 0));
  played.push(block_of(0.5F, 0.5F));
  EXPECT_EQ(played.take()[7], 0.5F);
  EXPECT_EQ(played.take()[0], 0.5F);
  EXPECT_EQ(played.take()[0], 0) << "nothing more was played";
}

TEST(PlayedSound, what_nobody_takes_is_dropped) {
  PlayedSound played;
  for (int i = 0; i < 10; ++i)
    played.push(block_of(static_cast<float>(i) / 10, static_cast<float>(i) / 10));
  EXPECT_NEAR(played.take()[0], 0.7, 1e-6);
}

}  // namespace
}  // namespace roomcast::viewer
