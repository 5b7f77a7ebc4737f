// SPDX-License-Identifier: Apache-2.0
// Pictures of a board seen straight on, 40 pixels per square.
#include "roomcast/alignment/calibration/charuco_finder.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace roomcast::alignment::calibration {
namespace {

constexpr double kSquare_px = 40;
const Eigen::Vector2d kBoardAt_px(20.3, 19.8);  // the board's top left corner

Eigen::Vector2d pixel_on_board(const CharucoBoard& board, const Eigen::Vector2d& point_m) {
  return kBoardAt_px + kSquare_px / board.square_m * point_m;
}

/// Whether a board is black whose tags are printed too far to the right.
bool is_black_with_tags_aside(const CharucoBoard& board, Eigen::Vector2d at_m, double aside_m) {
  const Eigen::Vector2d square = (at_m / board.square_m).array().floor();
  const bool is_white_square = static_cast<int>(square.x() + square.y()) % 2 != 0;
  const Eigen::Vector2d in_square = at_m / board.square_m - square;
  const bool is_inside = (in_square.array() - 0.5).abs().maxCoeff() < 0.45;
  if (is_white_square && is_inside) at_m.x() -= aside_m;
  return is_black(board, at_m);
}

/// The board on grey; each pixel is the mean of 4 x 4 samples.
ColorImage straight_board(const CharucoBoard& board, double tags_aside_px = 0) {
  constexpr int kSamplesAcross = 4;
  ColorImage color(320, 240);
  for (int y = 0; y < color.height(); ++y) {
    for (int x = 0; x < color.width(); ++x) {
      double sum = 0;
      for (int i = 0; i < kSamplesAcross * kSamplesAcross; ++i) {
        const Eigen::Vector2d pixel(x - 0.5 + (i % kSamplesAcross + 0.5) / kSamplesAcross,
                                    y - 0.5 + (i / kSamplesAcross + 0.5) / kSamplesAcross);
        const Eigen::Vector2d at_m = (pixel - kBoardAt_px) * (board.square_m / kSquare_px);
        const double aside_m = tags_aside_px * board.square_m / kSquare_px;
        sum += is_black_with_tags_aside(board, at_m, aside_m) ? 25 : 225;
      }
      const auto grey = static_cast<std::uint8_t>(sum / (kSamplesAcross * kSamplesAcross));
      color.at(x, y) = {grey, grey, grey};
    }
  }
  return color;
}

void cover_from(ColorImage& color, int left) {
  for (int y = 0; y < color.height(); ++y) {
    for (int x = left; x < color.width(); ++x) color.at(x, y) = {120, 120, 120};
  }
}

TEST(CharucoFinder, finds_every_corner_in_the_boards_order) {
  const CharucoBoard board;
  const auto corners = CharucoFinder(board).find(straight_board(board));
  ASSERT_EQ(corners.size(), static_cast<std::size_t>(board.corner_count()));
  for (int i = 0; i < board.corner_count(); ++i) {
    const SeenCorner& seen = corners[static_cast<std::size_t>(i)];
    EXPECT_EQ(seen.corner, i);
    // Each pixel is sampled 4 x 4 times, so edges are off by up to an eighth of a pixel. A corner
    // is where two of them meet.
    EXPECT_LT((seen.pixel - pixel_on_board(board, board.corner_m(i))).norm(), 0.18) << i;
  }
}

TEST(CharucoFinder, finds_corners_between_squares_not_where_tags_expect_them) {
  const CharucoBoard board;
  const auto corners = CharucoFinder(board).find(straight_board(board, 1.5));
  ASSERT_EQ(corners.size(), static_cast<std::size_t>(board.corner_count()));
  for (const SeenCorner& seen : corners) {
    EXPECT_LT((seen.pixel - pixel_on_board(board, board.corner_m(seen.corner))).norm(), 0.3)
        << seen.corner;
  }
}

TEST(CharucoFinder, finds_the_corners_of_the_tags_that_are_visible) {
  const CharucoBoard board;
  ColorImage color = straight_board(board);
  cover_from(color, static_cast<int>(kBoardAt_px.x() + 4.5 * kSquare_px));
  const auto corners = CharucoFinder(board).find(color);
  // Whole tags are left in the first four columns. Each corner touches two tags, one of the column
  // to its left, so the first four of each row's six corners are found.
  ASSERT_EQ(corners.size(), 16u);
  for (const SeenCorner& seen : corners) EXPECT_LT(seen.corner % 6, 4);
}

TEST(CharucoFinder, finds_nothing_where_there_is_no_board) {
  EXPECT_TRUE(CharucoFinder(CharucoBoard{}).find(ColorImage(320, 240, {120, 120, 120})).empty());
}

TEST(CharucoFinder, ignores_tags_that_the_board_does_not_have) {
  // A board of 3 x 2 squares has three tags; the others in the picture are not its own.
  const CharucoBoard small{3, 2};
  const auto corners = CharucoFinder(small).find(straight_board(CharucoBoard{}));
  for (const SeenCorner& seen : corners) EXPECT_LT(seen.corner, small.corner_count());
}

}  // namespace
}  // namespace roomcast::alignment::calibration
