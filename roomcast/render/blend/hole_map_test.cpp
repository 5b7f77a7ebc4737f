// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/hole_map.h"

#include <gtest/gtest.h>

namespace roomcast::render {
namespace {

TEST(HoleMap, knows_every_rectangle_with_a_hole) {
  constexpr int kWidth = 7, kHeight = 5;
  std::vector<float> depth(kWidth * kHeight, 0.9F);
  const Eigen::Vector2i middle(3, 2), corner(6, 4);
  const auto is_in = [](const Eigen::Vector2i& at, const Eigen::Vector2i& first,
                        const Eigen::Vector2i& last) {
    return (at.array() >= first.array()).all() && (at.array() <= last.array()).all();
  };
  for (const Eigen::Vector2i& hole : {middle, corner})
    depth[static_cast<std::size_t>(hole.y() * kWidth + hole.x())] = 1;
  HoleMap holes;
  holes.find(depth, kWidth);
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const Eigen::Vector2i first(i % kWidth, i / kWidth);
    for (int y = first.y(); y < kHeight; ++y) {
      for (int x = first.x(); x < kWidth; ++x) {
        const Eigen::Vector2i last(x, y);
        EXPECT_EQ(holes.has_hole(first, last),
                  is_in(middle, first, last) || is_in(corner, first, last))
            << first.transpose() << " to " << last.transpose();
      }
    }
  }
}

TEST(HoleMap, forgets_the_last_picture) {
  HoleMap holes;
  holes.find(std::vector<float>(12, 1.0F), 4);
  EXPECT_TRUE(holes.has_hole({0, 0}, {0, 0}));
  holes.find(std::vector<float>(6, 0.5F), 2);
  EXPECT_FALSE(holes.has_hole({0, 0}, {1, 2}));
}

}  // namespace
}  // namespace roomcast::render
