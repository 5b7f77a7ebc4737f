// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/text/text_picture.h"

#include <gtest/gtest.h>

namespace roomcast::viewer {
namespace {

constexpr Rgb8 kInk = {245, 100, 90};
constexpr int kTextWidth = 400, kTallest = 300;

ColorImage text_of(const std::string& sentence) {
  const std::vector<ColoredSentence> sentences = {{sentence, kInk}};
  return TextPicture(20).draw(sentences, kTextWidth, kTallest);
}

int inked_pixels(const ColorImage& picture) {
  int inked = 0;
  for (std::size_t i = 0; i < picture.view().pixel_count(); ++i)
    inked += picture.data()[i] == TextPicture::kGround ? 0 : 1;
  return inked;
}

TEST(TextPicture, has_letters_in_their_color) {
  const ColorImage picture = text_of("HHH");
  EXPECT_GT(inked_pixels(picture), 60);
  EXPECT_NE(std::find(picture.data(), picture.data() + picture.view().pixel_count(), kInk),
            picture.data() + picture.view().pixel_count());
}

TEST(TextPicture, grows_with_its_lines_and_breaks_between_words) {
  const int one_line = text_of("word").height();
  const std::string many = "word word word word word word word word word word word word word word";
  const ColorImage picture = text_of(many);
  EXPECT_GE(picture.height(), one_line + 25);
  EXPECT_NEAR(inked_pixels(picture), 14 * inked_pixels(text_of("word")), 200) << "none is cut";
}

TEST(TextPicture, never_grows_beyond_its_limit) {
  std::string endless;
  for (int i = 0; i < 500; ++i) endless += "endless ";
  EXPECT_EQ(text_of(endless).height(), kTallest);
  EXPECT_EQ(text_of(std::string(3000, 'W')).height(), kTallest) << "one word";
}

TEST(TextPicture, takes_any_bytes) {
  using std::string_literals::operator""s;  // with the zero
  EXPECT_GT(text_of("\xff\xfe\x80 \0 \n\n\xe2\x82"s).height(), 0);
  EXPECT_EQ(inked_pixels(text_of("")), 0);
}

}  // namespace
}  // namespace roomcast::viewer
