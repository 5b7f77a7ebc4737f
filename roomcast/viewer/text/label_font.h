// SPDX-License-Identifier: Apache-2.0
// LabelFont: letters as a texture, and where they go on a label. The letters are those of the
// desktop's DejaVu Sans (Latin, Greek, Cyrillic) where it is installed, else of the small font that
// comes with Dear ImGui (Latin only). Needs a GL context.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "roomcast/render/gl/gl_object.h"

struct ImFontAtlas;

namespace roomcast::viewer {

/// Two triangles, each corner: place on the label in metres, place in the texture.
struct LabelCorner {
  Eigen::Vector2f place_m, in_atlas;
};

struct LabelText {
  std::vector<LabelCorner> corners;  // 6 per letter
  float width_m = 0;                 // centred on x = 0, and on y = 0
};

/// Longer names are cut, as on the page.
inline constexpr float kWidestLabel_m = 0.6F;

class LabelFont {
 public:
  LabelFont();
  ~LabelFont();
  LabelFont(LabelFont&& other) noexcept;
  LabelFont& operator=(LabelFont&& other) noexcept;

  /// `utf8` may be anything; what the font does not have is a question mark.
  [[nodiscard]] LabelText lay_out(const std::string& utf8, float letter_height_m) const;
  /// One channel: how much of a pixel is covered.
  [[nodiscard]] const render::GlTexture& texture() const { return texture_; }

 private:
  std::unique_ptr<ImFontAtlas> atlas_;
  render::GlTexture texture_;
};

}  // namespace roomcast::viewer
