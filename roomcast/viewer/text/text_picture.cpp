// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/text/text_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <imgui.h>
#include <imgui_internal.h>

#include "roomcast/viewer/text/font_file.h"

namespace roomcast::viewer {
namespace {

struct TextLine {
  const char *begin, *end;
  Rgb8 color;
};

std::vector<TextLine> wrap(const ImFont& font, std::span<const ColoredSentence> sentences,
                           float width_px) {
  std::vector<TextLine> lines;
  for (const ColoredSentence& sentence : sentences) {
    const char* next = sentence.utf8.data();
    const char* const end = next + sentence.utf8.size();
    while (next < end) {
      const char* const stop = font.CalcWordWrapPositionA(1, next, end, width_px);
      lines.push_back({next, std::max(stop, next + 1), sentence.color});
      next = lines.back().end;
      while (next < end && *next == ' ') ++next;
    }
  }
  return lines;
}

std::uint8_t mixed(std::uint8_t below, std::uint8_t above, float coverage) {
  return static_cast<std::uint8_t>(std::lround(below + coverage * (above - below)));
}

/// The atlas has letters finer across than the picture.
class Pen {
 public:
  Pen(ImFontAtlas& atlas, ColorImage& picture) : font_(*atlas.Fonts[0]), picture_(picture) {
    atlas.GetTexDataAsAlpha8(&coverage_, &columns_, &rows_);
  }

  void write(const TextLine& line, float x, float y) {
    const char* next = line.begin;
    while (next < line.end) {
      unsigned int letter = 0;
      next += ImTextCharFromUtf8(&letter, next, line.end);
      const ImFontGlyph* const glyph = font_.FindGlyph(static_cast<ImWchar>(letter));
      if (letter == 0 || glyph == nullptr) continue;
      if (glyph->Visible) write(*glyph, x, y, line.color);
      x += glyph->AdvanceX;
    }
  }

 private:
  void write(const ImFontGlyph& glyph, float x, float y, Rgb8 color) {
    const int left = std::max(0, static_cast<int>(std::floor(x + glyph.X0)));
    const int top = std::max(0, static_cast<int>(std::floor(y + glyph.Y0)));
    for (int row = top; row < std::min<float>(picture_.height(), y + glyph.Y1); ++row) {
      const float down = (row + 0.5F - y - glyph.Y0) / (glyph.Y1 - glyph.Y0);
      for (int column = left; column < std::min<float>(picture_.width(), x + glyph.X1); ++column) {
        const float across = (column - x - glyph.X0) / (glyph.X1 - glyph.X0);
        const float covered = coverage(glyph, across, 1 / (glyph.X1 - glyph.X0), down);
        Rgb8& pixel = picture_.at(column, row);
        pixel = {mixed(pixel.r, color.r, covered), mixed(pixel.g, color.g, covered),
                 mixed(pixel.b, color.b, covered)};
      }
    }
  }

  /// The mean over `width` from `across`, shares of the glyph.
  [[nodiscard]] float coverage(const ImFontGlyph& glyph, float across, float width,
                               float down) const {
    const auto column_at = [&](float share) {
      const float u = std::lerp(glyph.U0, glyph.U1, std::clamp(share, 0.0F, 1.0F));
      return std::clamp(static_cast<int>(u * columns_), 0, columns_ - 1);
    };
    const float v = std::lerp(glyph.V0, glyph.V1, std::clamp(down, 0.0F, 1.0F));
    const int row = std::clamp(static_cast<int>(v * rows_), 0, rows_ - 1);
    const int first = column_at(across), last = std::max(first + 1, column_at(across + width));
    int sum = 0;
    for (int column = first; column < last; ++column) sum += coverage_[row * columns_ + column];
    return static_cast<float>(sum) / static_cast<float>(255 * (last - first));
  }

  const ImFont& font_;
  ColorImage& picture_;
  unsigned char* coverage_ = nullptr;  // of the atlas
  int columns_ = 0, rows_ = 0;
};

}  // namespace

TextPicture::TextPicture(float letter_height_px)
    : letter_height_px_(letter_height_px), atlas_(std::make_unique<ImFontAtlas>()) {
  add_font(*atlas_, letter_height_px);
  atlas_->Build();
}

TextPicture::~TextPicture() = default;

ColorImage TextPicture::draw(std::span<const ColoredSentence> sentences, int width_px,
                             int max_height_px) const {
  const float margin = letter_height_px_ / 2, line_height = 1.25F * letter_height_px_;
  const auto lines = wrap(*atlas_->Fonts[0], sentences, static_cast<float>(width_px) - 2 * margin);
  const float height = 2 * margin + line_height * static_cast<float>(lines.size());
  ColorImage picture(width_px, std::min(max_height_px, static_cast<int>(std::ceil(height))),
                     kGround);
  Pen pen(*atlas_, picture);
  float y = margin;
  for (const TextLine& line : lines) {
    if (y + line_height > static_cast<float>(picture.height())) break;
    pen.write(line, margin, y);
    y += line_height;
  }
  return picture;
}

}  // namespace roomcast::viewer
