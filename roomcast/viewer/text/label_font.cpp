// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/text/label_font.h"

#include <imgui.h>
#include <imgui_internal.h>

#include "roomcast/viewer/text/font_file.h"

namespace roomcast::viewer {
namespace {

constexpr float kLetterHeight_px = 40;

render::GlTexture upload(ImFontAtlas& atlas) {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsAlpha8(&pixels, &width, &height);
  render::GlTexture texture = render::make_smooth_texture(GL_R8, width, height);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RED, GL_UNSIGNED_BYTE, pixels);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  atlas.ClearTexData();
  return texture;
}

void add_letter(const ImFontGlyph& glyph, float pen_px, float metres_per_px, LabelText& label) {
  // The font's y goes down from the top of the line.
  const auto corner = [&](bool right, bool bottom) {
    const float x_px = pen_px + (right ? glyph.X1 : glyph.X0);
    const float y_px = kLetterHeight_px / 2 - (bottom ? glyph.Y1 : glyph.Y0);
    label.corners.push_back({{x_px * metres_per_px, y_px * metres_per_px},
                             {right ? glyph.U1 : glyph.U0, bottom ? glyph.V1 : glyph.V0}});
  };
  corner(false, false), corner(false, true), corner(true, false);
  corner(true, false), corner(false, true), corner(true, true);
}

}  // namespace

LabelFont::LabelFont() : atlas_(std::make_unique<ImFontAtlas>()) {
  add_font(*atlas_, kLetterHeight_px);
  atlas_->Build();
  texture_ = upload(*atlas_);
}

LabelFont::~LabelFont() = default;
LabelFont::LabelFont(LabelFont&& other) noexcept = default;
LabelFont& LabelFont::operator=(LabelFont&& other) noexcept = default;

LabelText LabelFont::lay_out(const std::string& utf8, float letter_height_m) const {
  const ImFont& font = *atlas_->Fonts[0];
  const float metres_per_px = letter_height_m / kLetterHeight_px;
  LabelText label;
  float pen_px = 0;
  const char* next = utf8.data();
  const char* const end = next + utf8.size();
  while (next < end) {
    unsigned int letter = 0;
    next += ImTextCharFromUtf8(&letter, next, end);
    const ImFontGlyph* glyph = font.FindGlyph(static_cast<ImWchar>(letter));
    if (letter == 0 || glyph == nullptr) continue;
    if ((pen_px + glyph->AdvanceX) * metres_per_px > kWidestLabel_m) break;
    if (glyph->Visible) add_letter(*glyph, pen_px, metres_per_px, label);
    pen_px += glyph->AdvanceX;
  }
  label.width_m = pen_px * metres_per_px;
  for (LabelCorner& corner : label.corners) corner.place_m.x() -= label.width_m / 2;
  return label;
}

}  // namespace roomcast::viewer
