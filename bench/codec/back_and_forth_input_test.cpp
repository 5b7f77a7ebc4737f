// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/back_and_forth_input.h"

#include <vector>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

/// One pixel whose depth is given for each frame.
class OnePixel final : public BenchInput {
 public:
  explicit OnePixel(std::vector<std::uint16_t> depths_mm) : depths_mm_(std::move(depths_mm)) {}
  std::string name() const override { return "one pixel"; }
  double fps() const override { return 10; }
  ColorReference color_reference() const override { return ColorReference::kInput; }
  Result<bool> next(BenchFrame& frame, BenchTruth&) override {
    if (at_ == depths_mm_.size()) return false;
    frame.depth_mm = DepthImage(1, 1, depths_mm_[at_++]);
    return true;
  }

 private:
  const std::vector<std::uint16_t> depths_mm_;
  std::size_t at_ = 0;
};

std::vector<int> played(std::vector<std::uint16_t> depths_mm, int frames) {
  auto input = play_back_and_forth(std::make_unique<OnePixel>(std::move(depths_mm)), 30).value();
  std::vector<int> seen;
  for (int i = 0; i < frames; ++i) {
    BenchFrame frame;
    BenchTruth truth;
    EXPECT_TRUE(input->next(frame, truth).value());
    seen.push_back(frame.depth_mm.at(0, 0));
  }
  return seen;
}

TEST(BackAndForthInput, turns_at_both_ends) {
  EXPECT_EQ(played({1, 2, 3}, 9), (std::vector{1, 2, 3, 2, 1, 2, 3, 2, 1}));
  EXPECT_EQ(played({7}, 3), (std::vector{7, 7, 7}));
}

TEST(BackAndForthInput, has_the_given_rate_and_the_median_of_still_surfaces) {
  auto input = play_back_and_forth(
                   std::make_unique<OnePixel>(std::vector<std::uint16_t>{2000, 2010, 2004}), 30)
                   .value();
  EXPECT_EQ(input->fps(), 30);
  BenchFrame frame;
  BenchTruth truth;
  ASSERT_TRUE(input->next(frame, truth).value());
  EXPECT_EQ(truth.still_mm.at(0, 0), 2004);
}

TEST(BackAndForthInput, refuses_a_recording_without_frames) {
  EXPECT_EQ(play_back_and_forth(std::make_unique<OnePixel>(std::vector<std::uint16_t>{}), 30)
                .error()
                .code,
            ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace roomcast::bench
