// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/text/font_file.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <imgui.h>

namespace roomcast::viewer {
namespace {

TEST(FontFile, has_letters_whatever_is_installed) {
  ImFontAtlas atlas;
  ImFont* const font = add_font(atlas, 20);
  ASSERT_NE(font, nullptr);
  ASSERT_TRUE(atlas.Build());
  EXPECT_NE(font->FindGlyphNoFallback('A'), nullptr);
}

TEST(FontFile, writes_names_of_many_languages_where_dejavu_is_installed) {
  if (!std::filesystem::exists("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"))
    GTEST_SKIP() << "fonts-dejavu-core is not installed";
  ImFontAtlas atlas;
  ImFont* const font = add_font(atlas, 20);
  ASSERT_TRUE(atlas.Build());
  for (const ImWchar letter : {0x00E9, 0x0141, 0x03A9, 0x0416}) {  // e acute, L stroke, Omega, Zhe
    EXPECT_NE(font->FindGlyphNoFallback(letter), nullptr) << letter;
  }
}

}  // namespace
}  // namespace roomcast::viewer
