// SPDX-License-Identifier: Apache-2.0
// Pictures with tags upright and ten pixels per cell.
#include "roomcast/alignment/board/tag_detector.h"

#include <utility>

#include <gtest/gtest.h>

#include "roomcast/alignment/board/tag_cells.h"

namespace roomcast::alignment {
namespace {

constexpr int kCell_px = 10;

/// Draws a tag with its white ring; (left, top) is its first pixel.
void draw_tag(ColorImage& color, int tag, int left, int top, Rgb8 black = {20, 20, 20},
              Rgb8 white = {220, 220, 220}) {
  const TagCells cells = *tag_cells(tag);
  for (int y = 0; y < kTagCells * kCell_px; ++y) {
    for (int x = 0; x < kTagCells * kCell_px; ++x) {
      const bool is_white =
          cells[static_cast<std::size_t>(y / kCell_px)][static_cast<std::size_t>(x / kCell_px)];
      color.at(left + x, top + y) = is_white ? white : black;
    }
  }
}

ColorImage grey_wall() {
  return {320, 200, {120, 120, 120}};
}

TEST(TagDetector, finds_a_tag_with_its_number_and_corners) {
  ColorImage color = grey_wall();
  draw_tag(color, 7, 60, 40);
  const auto tags = TagDetector().find(color);
  ASSERT_EQ(tags.size(), 1u);
  EXPECT_EQ(tags[0].id, 7);
  // The black square covers pixels 70 to 149 and 50 to 129: its edges lie half a pixel outside of
  // their centres. Edges are found to a quarter of a pixel, and a corner is on two of them.
  const double left = 69.5, right = 149.5, top = 49.5, bottom = 129.5;
  const std::array<Eigen::Vector2d, 4> printed = {
      Eigen::Vector2d(left, bottom), Eigen::Vector2d(right, bottom), Eigen::Vector2d(right, top),
      Eigen::Vector2d(left, top)};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_LT((tags[0].corners_px[i] - printed[i]).norm(), 0.35) << i;
}

TEST(TagDetector, finds_several_tags) {
  ColorImage color = grey_wall();
  draw_tag(color, 3, 20, 40);
  draw_tag(color, 11, 190, 40);
  const auto tags = TagDetector().find(color);
  ASSERT_EQ(tags.size(), 2u);
  for (const TagOutline& tag : tags) {
    const bool is_left = tag.corners_px[0].x() < 160;
    EXPECT_EQ(tag.id, is_left ? 3 : 11);
  }
}

TEST(TagDetector, finds_nothing_without_a_tag) {
  EXPECT_TRUE(TagDetector().find(grey_wall()).empty());
}

TEST(TagDetector, does_not_trust_a_tag_of_faint_contrast) {
  ColorImage color = grey_wall();
  draw_tag(color, 7, 60, 40, {110, 110, 110}, {130, 130, 130});
  EXPECT_TRUE(TagDetector().find(color).empty());
}

TEST(TagDetector, is_not_confused_by_an_earlier_picture) {
  ColorImage color = grey_wall();
  draw_tag(color, 7, 60, 40);
  TagDetector detector;
  ASSERT_EQ(detector.find(color).size(), 1u);
  EXPECT_TRUE(detector.find(grey_wall()).empty());
  TagDetector moved = std::move(detector);
  EXPECT_EQ(moved.find(color).size(), 1u);
}

TEST(TagDetector, keeps_the_luminance_of_the_picture) {
  ColorImage color(64, 48, {255, 255, 255});
  color.at(1, 0) = {255, 0, 0};
  color.at(2, 0) = {0, 255, 0};
  color.at(3, 1) = {0, 0, 255};
  TagDetector detector;
  EXPECT_TRUE(detector.find(color).empty());
  const auto grey = detector.grey();
  ASSERT_EQ(grey.width, 64);
  ASSERT_EQ(grey.height, 48);
  EXPECT_EQ(grey.at(0, 0), 255);
  // ITU-R BT.601, with weights in 256ths.
  EXPECT_NEAR(grey.at(1, 0), 0.299 * 255, 1.5);
  EXPECT_NEAR(grey.at(2, 0), 0.587 * 255, 1.5);
  EXPECT_NEAR(grey.at(3, 1), 0.114 * 255, 1.5);
}

}  // namespace
}  // namespace roomcast::alignment
