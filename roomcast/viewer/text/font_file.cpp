// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/text/font_file.h"

#include <array>
#include <filesystem>

#include <imgui.h>

namespace roomcast::viewer {
namespace {

constexpr std::array kFiles = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                               "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                               "/usr/share/fonts/TTF/DejaVuSans.ttf"};

/// First and last of each block, ended by 0: Latin, Greek, Cyrillic, punctuation.
constexpr std::array<ImWchar, 9> kLetters = {0x0020, 0x024F, 0x0370, 0x052F, 0x2010,
                                             0x2044, 0x20AC, 0x20AC, 0};

}  // namespace

ImFont* add_font(ImFontAtlas& atlas, float height_px) {
  for (const char* file : kFiles) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) continue;
    if (ImFont* font = atlas.AddFontFromFileTTF(file, height_px, nullptr, kLetters.data()))
      return font;
  }
  ImFontConfig config;
  config.SizePixels = height_px;
  return atlas.AddFontDefault(&config);
}

}  // namespace roomcast::viewer
