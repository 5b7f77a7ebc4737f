// SPDX-License-Identifier: Apache-2.0
// TextPicture: draws sentences into a picture, each in its colour, on a dark ground, wrapped
// between words. For places that have no Dear ImGui window, such as a headset. Fonts as LabelFont.
// Pure: no GL context.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "roomcast/core/image.h"

struct ImFontAtlas;

namespace roomcast::viewer {

struct ColoredSentence {
  std::string utf8;
  Rgb8 color;
};

class TextPicture {
 public:
  explicit TextPicture(float letter_height_px);
  ~TextPicture();
  TextPicture(const TextPicture&) = delete;
  TextPicture& operator=(const TextPicture&) = delete;

  /// As high as the sentences need, up to `max_height_px`; lines beyond are left out.
  [[nodiscard]] ColorImage draw(std::span<const ColoredSentence> sentences, int width_px,
                                int max_height_px) const;

  static constexpr Rgb8 kGround = {13, 17, 23};

 private:
  float letter_height_px_;
  std::unique_ptr<ImFontAtlas> atlas_;
};

}  // namespace roomcast::viewer
