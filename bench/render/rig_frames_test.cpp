// SPDX-License-Identifier: Apache-2.0
#include "bench/render/rig_frames.h"

#include <gtest/gtest.h>

#include "bench/render/striped_rig_fixture.h"
#include "bench/render/truth_view.h"

namespace roomcast::bench {
namespace {

using RigFramesTest = StripedRigTest;

/// So that the figures of a bench do not depend on what was measured before.
TEST_F(RigFramesTest, restarted_it_has_forgotten_what_the_frames_before_showed) {
  ASSERT_NO_FATAL_FAILURE(write_rig());
  constexpr int kHoleX = 40, kHoleY = 30;
  DepthImage with_hole(kLens.width, kLens.height, 2000);
  render::fill_box(with_hole, kHoleX, kHoleY, kHoleX + 20, kHoleY + 20, std::uint16_t{0});
  ASSERT_TRUE(io::write_depth_png(folder / "rig" / "s0" / "depth" / "000003.png", with_hole).ok());
  const auto views = read_truth_views(folder / "rig");
  ASSERT_TRUE(views.ok()) << views.error().message;
  auto frames = RigFrames::open(folder / "rig", views->rig, 1);
  ASSERT_TRUE(frames.ok()) << frames.error().message;
  RegisteredFrame frame;
  const auto read = [&](std::uint64_t number) {
    ASSERT_TRUE(frames->read(frames->sensors()[0], number, frame).ok());
  };
  for (const std::uint64_t number : {0, 1, 2, 3}) ASSERT_NO_FATAL_FAILURE(read(number));
  EXPECT_NE(frame.color.color.at(kHoleX + 10, kHoleY + 10), Rgb8{});
  ASSERT_TRUE(frames->restart().ok());
  ASSERT_NO_FATAL_FAILURE(read(3));
  EXPECT_EQ(frame.color.color.at(kHoleX + 10, kHoleY + 10), Rgb8{});
}

}  // namespace
}  // namespace roomcast::bench
