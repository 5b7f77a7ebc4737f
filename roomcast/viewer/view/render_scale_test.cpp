// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/view/render_scale.h"

#include <gtest/gtest.h>

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

HostTime at(nanoseconds since_start) {
  return HostTime(1h + since_start);
}

void judge_often(RenderScale& scale, nanoseconds drawing, HostTime now) {
  for (std::size_t i = 0; i < RenderScale::kDrawsToJudge; ++i) scale.judge(drawing, now);
}

TEST(RenderScale, begins_with_all_pixels_and_keeps_them_while_drawing_keeps_up) {
  RenderScale scale;
  judge_often(scale, 30ms, at(0s));
  EXPECT_EQ(scale.scale(), 1);
}

TEST(RenderScale, slow_drawing_makes_it_coarser_and_no_coarser_than_the_last_step) {
  RenderScale scale;
  judge_often(scale, 200ms, at(0s));
  EXPECT_EQ(scale.scale(), 0.75);
  for (int i = 0; i < 20; ++i) judge_often(scale, 200ms, at(0s));
  EXPECT_EQ(scale.scale(), RenderScale::kScales.back());
}

TEST(RenderScale, one_slow_picture_changes_nothing) {
  RenderScale scale;
  scale.judge(2s, at(0s));
  for (int i = 0; i < 4; ++i) scale.judge(10ms, at(0s));
  EXPECT_EQ(scale.scale(), 1);
}

TEST(RenderScale, quick_drawing_makes_it_finer_after_a_while_and_a_mistake_costs_patience) {
  RenderScale scale;
  judge_often(scale, 200ms, at(0s));
  judge_often(scale, 5ms, at(1s));
  EXPECT_EQ(scale.scale(), 0.75) << "too soon";
  judge_often(scale, 5ms, at(4s));
  EXPECT_EQ(scale.scale(), 1);
  judge_often(scale, 200ms, at(5s));
  judge_often(scale, 5ms, at(9s));
  EXPECT_EQ(scale.scale(), 0.75) << "it waits longer now";
  judge_often(scale, 5ms, at(12s));
  EXPECT_EQ(scale.scale(), 1);
}

}  // namespace
}  // namespace roomcast::viewer
