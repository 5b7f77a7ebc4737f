// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/render/surface/sensor_pictures_fixture.h"
#include "roomcast/render/view/offscreen_target.h"

namespace roomcast::render {
namespace {

using OffscreenTargetTest = GlTest;

constexpr int kWidth = 7, kHeight = 5;  // odd: a row's bytes are not a multiple of four

TEST_F(OffscreenTargetTest, clear_makes_one_color_that_no_sensor_drew) {
  const Result<OffscreenTarget> target = OffscreenTarget::create(kWidth, kHeight);
  ASSERT_TRUE(target.ok()) << target.error().message;
  target->clear(kYellow);
  EXPECT_EQ(target->read_color(), ColorImage(kWidth, kHeight, kYellow));
  EXPECT_EQ(target->read_sensors(), Image<std::int32_t>(kWidth, kHeight, kDrawnByNoSensor));
}

TEST_F(OffscreenTargetTest, the_top_row_is_read_back_first) {
  const Result<OffscreenTarget> target = OffscreenTarget::create(kWidth, kHeight);
  ASSERT_TRUE(target.ok()) << target.error().message;
  target->clear(kBlue);
  glEnable(GL_SCISSOR_TEST);
  glScissor(1, kHeight - 1, kWidth - 1, 1);  // OpenGL counts rows from the bottom
  target->clear(kRed);
  glDisable(GL_SCISSOR_TEST);

  ColorImage expected(kWidth, kHeight, kBlue);
  fill_box(expected, 1, 0, kWidth, 1, kRed);
  EXPECT_EQ(target->read_color(), expected);
}

TEST_F(OffscreenTargetTest, illegal_sizes_are_refused) {
  for (const auto& [width, height] : {std::pair(0, 10), {10, -1}, {8193, 10}, {10, 8193}}) {
    const Result<OffscreenTarget> target = OffscreenTarget::create(width, height);
    ASSERT_FALSE(target.ok());
    EXPECT_EQ(target.error().code, ErrorCode::kInvalidArgument);
  }
}

}  // namespace
}  // namespace roomcast::render
