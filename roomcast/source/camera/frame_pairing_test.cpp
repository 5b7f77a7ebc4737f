// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/frame_pairing.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::source {
namespace {

using std::chrono::milliseconds;

/// Pictures are distinguished by their first pixel.
class Pairing : public testing::Test {
 protected:
  struct Pair {
    int depth, color;
    nanoseconds time;
    bool operator==(const Pair&) const = default;
  };

  void depth(int number, int at_ms) {
    DepthImage picture(2, 2, static_cast<std::uint16_t>(number));
    pairing_.depth(milliseconds(at_ms), picture);
  }
  void color(int number, int at_ms) {
    ColorImage picture(2, 2, Rgb8{static_cast<std::uint8_t>(number), 0, 0});
    pairing_.color(milliseconds(at_ms), picture);
  }

  std::vector<Pair> pairs_;
  FramePairing pairing_{
      30, true, [this](const CapturedFrame& frame) {
        EXPECT_EQ(frame.index, pairs_.size());
        pairs_.push_back({frame.depth_mm.at(0, 0), frame.color.at(0, 0).r, frame.device_time});
      }};
};

TEST_F(Pairing, depth_and_colour_of_an_instant_become_a_frame_whichever_comes_first) {
  depth(1, 100), color(1, 105);
  color(2, 130), depth(2, 133);
  EXPECT_THAT(pairs_,
              testing::ElementsAre(Pair{1, 1, milliseconds(100)}, Pair{2, 2, milliseconds(133)}));
}

TEST_F(Pairing, pictures_further_apart_than_half_a_period_are_not_paired) {
  color(1, 100), depth(1, 117), color(2, 133);
  EXPECT_THAT(pairs_, testing::ElementsAre(Pair{1, 2, milliseconds(117)}));
}

TEST_F(Pairing, depth_without_colour_is_counted) {
  depth(1, 100), depth(2, 133), color(2, 140);
  EXPECT_THAT(pairs_, testing::ElementsAre(Pair{2, 2, milliseconds(133)}));
  EXPECT_EQ(pairing_.unpaired_count(), 1U);
}

TEST_F(Pairing, a_colour_picture_is_used_once) {
  color(1, 100), depth(1, 100), depth(2, 110);
  EXPECT_EQ(pairs_.size(), 1U);
}

TEST_F(Pairing, frames_from_before_a_disconnect_are_not_paired_with_later_ones) {
  depth(1, 100);
  pairing_.forget();
  color(2, 101);
  EXPECT_TRUE(pairs_.empty());
}

TEST(PairingWithoutColour, every_depth_picture_is_a_frame_and_gives_memory_back) {
  int frames = 0;
  FramePairing pairing(30, false, [&](CapturedFrame& frame) {
    EXPECT_TRUE(frame.color.empty());
    ++frames;
  });
  DepthImage first(4, 4, 7), second(4, 4, 8);
  const std::uint16_t* const memory = first.data();
  pairing.depth(milliseconds(0), first);
  pairing.depth(milliseconds(33), second);
  EXPECT_EQ(frames, 2);
  EXPECT_EQ(second.data(), memory);
}

}  // namespace
}  // namespace roomcast::source
