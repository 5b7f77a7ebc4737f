// SPDX-License-Identifier: Apache-2.0
// LabelFont: glyphs in a texture, and their layout on a label. Uses the desktop's DejaVu Sans
// (Latin, Greek, Cyrillic) if it is installed, else the small font of Dear ImGui (Latin only).
// Needs a GL context.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "roomcast/render/gl/gl_object.h"

struct ImFontAtlas;

namespace roomcast::viewer {

/// A corner of one of a glyph's two triangles: position on the label in metres, position in the
/// texture.
struct LabelCorner {
  Eigen::Vector2f place_m, in_atlas;
};

struct LabelText {
  std::vector<LabelCorner> corners;  // 6 per letter
  float width_m = 0;                 // centred on x = 0, and on y = 0
};

/// Longer names are truncated, as on the page.
inline constexpr float kWidestLabel_m = 0.6F;

class LabelFont {
 public:
  LabelFont();
  ~LabelFont();
  LabelFont(LabelFont&& other) noexcept;
  LabelFont& operator=(LabelFont&& other) noexcept;

  /// `utf8` may be any bytes; characters missing in the font become question marks.
  [[nodiscard]] LabelText lay_out(const std::string& utf8, float letter_height_m) const;
  /// One channel: coverage.
  [[nodiscard]] const render::GlTexture& texture() const { return texture_; }

 private:
  std::unique_ptr<ImFontAtlas> atlas_;
  render::GlTexture texture_;
};

}  // namespace roomcast::viewer
