// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include <gtest/gtest.h>

#include "roomcast/render/gl/egl_display.h"

namespace roomcast::render {
namespace {

TEST(DisplayWithoutWindow, is_the_same_each_time) {
  const auto first = display_without_window();
  const auto second = display_without_window();
  ASSERT_TRUE(first.ok()) << first.error().message;
  ASSERT_TRUE(second.ok()) << second.error().message;
  EXPECT_EQ(*first, *second);
}

TEST(DisplayWithoutWindow, may_be_asked_to_draw_in_software) {
  ASSERT_EQ(::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1), 0);
  const auto display = display_without_window();
  ::unsetenv("LIBGL_ALWAYS_SOFTWARE");
  EXPECT_TRUE(display.ok()) << display.error().message;
}

TEST(DisplayWithoutWindow, its_absence_says_what_to_install) {
  const Error error = no_drawing_without_window("EGL did not start");
  EXPECT_EQ(error.code, ErrorCode::kUnavailable);
  EXPECT_NE(error.message.find("EGL did not start"), std::string::npos) << error.message;
  EXPECT_NE(error.message.find("apt install"), std::string::npos) << error.message;
}

}  // namespace
}  // namespace roomcast::render
