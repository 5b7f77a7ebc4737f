// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "roomcast/viewer/window/view_window.h"

namespace roomcast::viewer {
namespace {

class ViewWindowTest : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("SDL_VIDEODRIVER", "offscreen", 1);
    ViewWindowOptions options;
    options.size = {200, 100};
    auto opened = ViewWindow::open(options);
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    window = std::move(*opened);
  }

  std::unique_ptr<ViewWindow> window;
};

TEST_F(ViewWindowTest, opens_without_a_display_and_has_opengl) {
  EXPECT_EQ(window->size(), (PictureSize{200, 100}));
  EXPECT_EQ(window->pixels_per_unit(), 1);
  EXPECT_FALSE(window->is_hidden());
  EXPECT_GE(epoxy_gl_version(), 45);
}

TEST_F(ViewWindowTest, where_there_is_no_display_says_so_instead_of_running_unseen) {
  window.reset();
  for (const char* name : {"SDL_VIDEODRIVER", "DISPLAY", "WAYLAND_DISPLAY"}) ::unsetenv(name);
  const auto opened = ViewWindow::open({});
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().code, ErrorCode::kUnavailable);
  EXPECT_NE(opened.error().message.find("there is no display"), std::string::npos)
      << opened.error().message;
}

TEST_F(ViewWindowTest, waits_for_the_screen_until_it_is_told_not_to) {
  EXPECT_TRUE(window->waits_for_screen());
  window->wait_for_screen(false);
  EXPECT_FALSE(window->waits_for_screen());
}

TEST_F(ViewWindowTest, shows_a_picture_of_its_size_pixel_by_pixel) {
  auto picture = render::OffscreenTarget::create(200, 100);
  ASSERT_TRUE(picture.ok());
  picture->clear({10, 20, 30});
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 90, 50, 10);  // the upper left corner
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  window->show(*picture);
  const ColorImage shown = window->read();
  EXPECT_EQ(shown.at(0, 0), (Rgb8{255, 0, 0}));
  EXPECT_EQ(shown.at(49, 9), (Rgb8{255, 0, 0}));
  EXPECT_EQ(shown.at(50, 10), (Rgb8{10, 20, 30}));
  window->present();
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(ViewWindowTest, scales_a_smaller_picture_to_all_of_it) {
  auto picture = render::OffscreenTarget::create(100, 50);
  ASSERT_TRUE(picture.ok());
  picture->clear({10, 20, 30});
  window->show(*picture);
  const ColorImage shown = window->read();
  EXPECT_EQ(shown.at(199, 99), (Rgb8{10, 20, 30}));
  EXPECT_EQ(shown.at(0, 0), (Rgb8{10, 20, 30}));
}

TEST(ViewWindow, without_a_display_the_error_gives_advice) {
  ::setenv("SDL_VIDEODRIVER", "x11", 1);
  const char* const display = std::getenv("DISPLAY");
  const std::string before = display != nullptr ? display : "";
  ::unsetenv("DISPLAY");
  const auto window = ViewWindow::open({});
  if (!before.empty()) ::setenv("DISPLAY", before.c_str(), 1);
  ASSERT_FALSE(window.ok());
  EXPECT_EQ(window.error().code, ErrorCode::kUnavailable);
  EXPECT_NE(window.error().message.find("use --headless --png FILE"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::viewer
