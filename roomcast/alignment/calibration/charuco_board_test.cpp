// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/calibration/charuco_board.h"

#include <cstdio>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::alignment::calibration {
namespace {

TEST(CharucoBoard, black_and_white_meet_at_the_corners) {
  const CharucoBoard board;
  ASSERT_EQ(board.corner_count(), 24);
  const double d = 0.02 * board.square_m;
  for (int i = 0; i < board.corner_count(); ++i) {
    const Eigen::Vector2d corner = board.corner_m(i);
    const bool top_left = is_black(board, corner + Eigen::Vector2d(-d, -d));
    EXPECT_EQ(is_black(board, corner + Eigen::Vector2d(d, d)), top_left);
    EXPECT_NE(is_black(board, corner + Eigen::Vector2d(d, -d)), top_left);
    EXPECT_NE(is_black(board, corner + Eigen::Vector2d(-d, d)), top_left);
  }
}

TEST(CharucoBoard, every_white_square_has_a_tag_with_a_black_rim) {
  const CharucoBoard board;
  const auto tags = tags_of(board);
  ASSERT_EQ(tags.size(), 17U);
  for (const BoardTag& tag : tags) {
    const auto corners = tag_corners_m(board, tag);
    const Eigen::Vector2d middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    for (const Eigen::Vector2d& corner : corners) {
      EXPECT_TRUE(is_black(board, middle + 0.97 * (corner - middle)));
      EXPECT_FALSE(is_black(board, middle + 1.05 * (corner - middle)));
    }
  }
}

TEST(CharucoBoard, a_page_gets_the_largest_board_of_whole_millimetres) {
  EXPECT_DOUBLE_EQ(board_for(kA3Across).square_m, 0.053);
  EXPECT_DOUBLE_EQ(board_for(kA4Across).square_m, 0.036);
  EXPECT_FALSE(charuco_pdf({60, 60}).ok());
}

/// Whether one of the filled rectangles of a page covers a point, in points from the bottom left.
bool is_filled(const std::string& pdf, double x, double y) {
  std::istringstream lines(pdf);
  for (std::string line; std::getline(lines, line);) {
    double left = 0, bottom = 0, width = 0, height = 0;
    if (std::sscanf(line.c_str(), "%lf %lf %lf %lf re f", &left, &bottom, &width, &height) != 4)
      continue;
    if (x >= left && x < left + width && y >= bottom && y < bottom + height) return true;
  }
  return false;
}

TEST(CharucoBoard, what_is_printed_is_what_is_looked_for) {
  const auto pdf = charuco_pdf(kA4Across);
  ASSERT_TRUE(pdf.ok());
  EXPECT_THAT(*pdf, testing::StartsWith("%PDF-1.4"));
  EXPECT_THAT(*pdf, testing::HasSubstr("squares are 36 mm wide"));
  const CharucoBoard board = board_for(kA4Across);
  const double left_mm = 0.5 * (297 - 1000 * board.size_m().x()), top_mm = 10;
  int black = 0;
  for (double v = 0.0011; v < board.size_m().y(); v += 0.004137) {
    for (double u = 0.0013; u < board.size_m().x(); u += 0.004273) {
      const double x = (left_mm + 1000 * u) * 72 / 25.4;
      const double y = (210 - top_mm - 1000 * v) * 72 / 25.4;
      const bool expected = is_black(board, {u, v});
      black += expected;
      ASSERT_EQ(is_filled(*pdf, x, y), expected) << u << " " << v;
    }
  }
  EXPECT_GT(black, 1000);
}

}  // namespace
}  // namespace roomcast::alignment::calibration
