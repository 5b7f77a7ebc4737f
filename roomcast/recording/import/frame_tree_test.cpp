// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/frame_tree.h"

#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

RigidTransform shifted(double x, double y) {
  RigidTransform transform;
  transform.translation_m = {x, y, 0};
  return transform;
}

TEST(FrameTree, joins_frames_over_their_common_ancestor) {
  FrameTree tree;
  tree.add("link", "depth", shifted(0, 1));
  tree.add("/link", "color", shifted(5, 0));
  tree.add("map", "link", shifted(100, 100));
  const auto color_from_depth = tree.between("color", "/depth");
  ASSERT_TRUE(color_from_depth);
  EXPECT_EQ(color_from_depth->translation_m, Eigen::Vector3d(-5, 1, 0));
  EXPECT_EQ(tree.between("depth", "depth")->translation_m, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(tree.between("unknown", "unknown")->translation_m, Eigen::Vector3d(0, 0, 0));
  EXPECT_FALSE(tree.between("color", "elsewhere"));
}

TEST(FrameTree, the_root_is_the_frame_without_a_parent) {
  FrameTree tree;
  tree.add("map", "/link", shifted(1, 0));
  tree.add("link", "depth", shifted(0, 1));
  EXPECT_EQ(tree.root_above("/depth"), "map");
  EXPECT_FALSE(tree.root_above("map"));
  EXPECT_FALSE(tree.root_above("alone"));
}

TEST(FrameTree, a_loop_ends) {
  FrameTree tree;
  tree.add("a", "b", shifted(1, 0));
  tree.add("b", "a", shifted(1, 0));
  EXPECT_TRUE(tree.between("a", "b"));
  EXPECT_FALSE(tree.between("a", "c"));
  EXPECT_FALSE(tree.root_above("a"));
}

}  // namespace
}  // namespace roomcast::recording
