// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/filtered_input.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "roomcast/sensor/disturbed_wall_fixture.h"

namespace roomcast::bench {
namespace {

/// A wall with interference, without end.
class WallInput final : public BenchInput {
 public:
  std::string name() const override { return "wall"; }
  double fps() const override { return sensor::kWallFps; }
  ColorReference color_reference() const override { return ColorReference::kInput; }
  Result<bool> next(BenchFrame& frame, BenchTruth&) override {
    frame.depth_mm = sensor::DisturbedWall{.lost = 0.1}.frame(number_++);
    return true;
  }

 private:
  unsigned number_ = 0;
};

TEST(FilteredInputTest, readings_that_come_and_go_are_held_once_they_are_known) {
  const auto input = without_interference(std::make_unique<WallInput>());
  BenchFrame frame;
  BenchTruth truth;
  const auto missing = [&] {
    EXPECT_TRUE(input->next(frame, truth).value());
    const auto depth = frame.depth_mm.view();
    return std::count(depth.data, depth.data + depth.pixel_count(), 0);
  };
  const auto first = missing();
  for (int i = 0; i < 100; ++i) (void)missing();
  EXPECT_GT(first, 1500);
  EXPECT_LT(missing(), first / 5);
  EXPECT_EQ(input->fps(), sensor::kWallFps);
  EXPECT_NE(input->name().find("wall"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::bench
