// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/color_activity.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

constexpr FrameRole kKey{true, 0}, kBase{false, 0}, kUpper{false, 1};

// A picture of 40x24 pixels: 5x3 blocks of 8x8, 3x2 of 16x16.
MaskImage changed_at(int x, int y) {
  MaskImage changed(5, 3, 0);
  changed.at(x, y) = 1;
  return changed;
}
const MaskImage kNothing(5, 3, 0);

int count(MaskView active) {
  int n = 0;
  for (int y = 0; y < active.height; ++y) {
    for (int x = 0; x < active.width; ++x) n += active.at(x, y);
  }
  return n;
}

void come_to_rest(ColorActivity& activity) {
  for (int i = 0; i < 30; ++i) activity.update(kNothing, kBase);
}

TEST(ColorActivity, a_key_frame_is_active_everywhere) {
  ColorActivity activity;
  const MaskView active = activity.update(kNothing, kKey);
  EXPECT_EQ(active.width, 3);
  EXPECT_EQ(active.height, 2);
  EXPECT_EQ(count(active), 6);
}

TEST(ColorActivity, after_a_key_frame_only_reference_frames_improve_it) {
  ColorActivity activity;
  activity.update(kNothing, kKey);
  EXPECT_EQ(count(activity.update(kNothing, kUpper)), 0);
  EXPECT_EQ(count(activity.update(kNothing, kBase)), 6);
}

TEST(ColorActivity, a_still_picture_comes_to_rest) {
  ColorActivity activity;
  activity.update(kNothing, kKey);
  come_to_rest(activity);
  EXPECT_EQ(count(activity.update(kNothing, kBase)), 0);
}

TEST(ColorActivity, changes_are_active_in_any_layer_and_improved_for_a_while) {
  ColorActivity activity;
  activity.update(kNothing, kKey);
  come_to_rest(activity);
  const MaskImage corner = changed_at(4, 2);
  MaskView active = activity.update(corner, kUpper);
  EXPECT_EQ(count(active), 1);
  EXPECT_EQ(active.at(2, 1), 1);
  EXPECT_EQ(count(activity.update(kNothing, kBase)), 0) << "the upper layer left no trace";
  EXPECT_EQ(count(activity.update(corner, kBase)), 1);
  EXPECT_EQ(count(activity.update(kNothing, kBase)), 1);
  come_to_rest(activity);
  EXPECT_EQ(count(activity.update(kNothing, kBase)), 0);
}

TEST(ColorActivity, still_blocks_are_improved_band_by_band) {
  ColorActivity activity;
  activity.update(kNothing, kKey);
  come_to_rest(activity);
  activity.improve_still_blocks();
  int improved = 0, most = 0;
  for (int i = 0; i < 2 * ColorActivity::kBands; ++i) {
    EXPECT_EQ(count(activity.update(kNothing, kUpper)), 0);
    const int active = count(activity.update(kNothing, kBase));
    improved += active;
    most = std::max(most, active);
  }
  EXPECT_EQ(improved, 2 * 6) << "every block twice";
  EXPECT_LT(most, 6) << "not all in one frame";
  EXPECT_FALSE(activity.is_improving());
}

TEST(ColorActivity, what_nobody_needs_is_left_out_and_owed) {
  ColorActivity activity;
  activity.update(kNothing, kKey);
  come_to_rest(activity);
  const MaskImage corner = changed_at(4, 2);
  MaskImage left_out(3, 2, 0);
  left_out.at(2, 1) = 1;
  EXPECT_EQ(count(activity.update(corner, kBase, left_out)), 0);
  EXPECT_EQ(count(activity.update(kNothing, kUpper, left_out)), 0);
  EXPECT_EQ(count(activity.update(kNothing, kBase, left_out)), 0);
  EXPECT_EQ(count(activity.update(kNothing, kUpper)), 1) << "it is needed again";
  EXPECT_EQ(count(activity.update(kNothing, kBase)), 1) << "the upper layer left no trace";
  EXPECT_EQ(count(activity.update(kNothing, kUpper)), 0);
  EXPECT_EQ(count(activity.update(kNothing, kBase)), 1) << "as any change, it is improved";
}

TEST(ColorActivity, a_change_in_an_upper_layer_alone_is_not_owed) {
  ColorActivity activity;
  activity.update(kNothing, kKey);
  come_to_rest(activity);
  const MaskImage all(3, 2, 1);
  EXPECT_EQ(count(activity.update(changed_at(0, 0), kUpper, all)), 0);
  EXPECT_EQ(count(activity.update(kNothing, kBase)), 0);
}

TEST(ColorActivity, a_key_frame_leaves_nothing_out_and_pays_what_is_owed) {
  ColorActivity activity;
  activity.update(kNothing, kKey);
  come_to_rest(activity);
  const MaskImage all(3, 2, 1);
  activity.update(changed_at(0, 0), kBase, all);
  EXPECT_EQ(count(activity.update(kNothing, kKey, all)), 6);
  EXPECT_EQ(count(activity.update(kNothing, kUpper)), 0);
}

}  // namespace
}  // namespace roomcast::codec
