// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/modeler/kept_views.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/recording/export/wall_fixture.h"
#include "roomcast/recording/modeler/room_modeler.h"

namespace roomcast::recording {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class KeptViewsTest : public testing::Test {
 protected:
  /// Both sensors' pictures; at other times than those before.
  void see(const FrameSet& set, int times = 1) {
    for (int i = 0; i < times; ++i) {
      FrameSet later = set;
      for (SetFrame& frame : later.frames) frame.time = std::chrono::seconds(4 * ++number_);
      ASSERT_TRUE(views.add(wall_sensors(), later).ok());
    }
  }
  /// The wall of which the near sensor sees the left `columns`, of the upper `rows`, at another
  /// distance.
  static FrameSet wall_with(int columns, std::uint16_t depth_mm, int rows = 48) {
    FrameSet set = wall_set();
    auto pictures = std::make_shared<codec::DecodedFrame>(*set.frames[0].pictures);
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) pictures->depth_mm.at(x, y) = depth_mm;
    }
    set.frames[0].pictures = pictures;
    return set;
  }

  KeptViews views{running_room_options()};

 private:
  int number_ = 0;
};

TEST_F(KeptViewsTest, are_worth_fusing_once_they_were_seen_several_times) {
  EXPECT_FALSE(views.are_worth_fusing()) << "there is none";
  EXPECT_FALSE(views.needs_more_of("near"));
  see(wall_set(), 2);
  EXPECT_FALSE(views.are_worth_fusing());
  EXPECT_TRUE(views.needs_more_of("near"));
  see(wall_set());
  EXPECT_FALSE(views.needs_more_of("near"));
  EXPECT_TRUE(views.are_worth_fusing());
  EXPECT_EQ(views.surfaces().size(), 2u);
  see(wall_set(), 5);
  EXPECT_FALSE(views.are_worth_fusing()) << "nothing is different";
}

TEST_F(KeptViewsTest, furniture_that_goes_is_forgotten_within_three_pictures) {
  see(wall_with(20, 1500), 20);
  (void)views.surfaces();
  see(wall_set(), 2);
  EXPECT_FALSE(views.are_worth_fusing());
  see(wall_set());
  EXPECT_TRUE(views.are_worth_fusing());
  const KeptViews::Saved now = views.saved();
  const auto& sensor = now.sensors[now.set.frames[1].sensor];
  EXPECT_EQ(sensor.name, "near");
  EXPECT_EQ(now.set.frames[1].pictures->depth_mm.at(3, 20), 2000);
}

TEST_F(KeptViewsTest, what_is_left_of_furniture_is_worth_fusing_just_after_a_change) {
  see(wall_with(1, 1500, 8), 20);
  (void)views.surfaces();
  see(wall_set(), 4);
  EXPECT_FALSE(views.are_worth_fusing());
  EXPECT_TRUE(views.are_worth_fusing(true));
}

TEST_F(KeptViewsTest, a_person_who_walks_past_is_in_no_view) {
  see(wall_set(), 5);
  (void)views.surfaces();
  see(wall_with(20, 1000), 2);
  see(wall_set(), 2);
  EXPECT_FALSE(views.are_worth_fusing());
}

TEST_F(KeptViewsTest, somebody_before_the_sensor_changes_nothing_a_changed_room_does) {
  see(wall_set(), 5);
  (void)views.surfaces();
  see(wall_with(60, 400), 3);
  EXPECT_FALSE(views.are_worth_fusing());
  see(wall_with(60, 400), 8);
  EXPECT_TRUE(views.are_worth_fusing());
}

TEST_F(KeptViewsTest, light_that_changes_is_noticed) {
  see(wall_set(), 3);
  (void)views.surfaces();
  FrameSet dark = wall_set();
  for (SetFrame& frame : dark.frames) {
    auto pictures = std::make_shared<codec::DecodedFrame>(*frame.pictures);
    pictures->color = ColorImage(64, 48, Rgb8{20, 20, 20});
    frame.pictures = pictures;
  }
  see(dark, 3);
  EXPECT_TRUE(views.are_worth_fusing());
}

TEST_F(KeptViewsTest, the_view_of_a_sensor_that_leaves_stays_and_of_one_that_is_forgotten_goes) {
  see(wall_set(), 3);
  (void)views.surfaces();
  FrameSet alone = wall_set();
  alone.frames.pop_back();
  see(alone, 3);
  EXPECT_THAT(views.sensors(), ElementsAre("far", "near"));
  EXPECT_FALSE(views.are_worth_fusing());
  views.forget("far");
  EXPECT_THAT(views.sensors(), ElementsAre("near"));
  EXPECT_TRUE(views.are_worth_fusing());
}

TEST_F(KeptViewsTest, a_sensor_that_moves_begins_anew_and_one_that_is_placed_better_does_not) {
  see(wall_set(), 3);
  (void)views.surfaces();
  FrameSet refined = wall_set();
  refined.frames[0].world_from_depth->translation_m.x() += 0.02;
  see(refined);
  EXPECT_TRUE(views.are_worth_fusing());
  EXPECT_EQ(views.surfaces().size(), 2u);
  FrameSet moved = wall_set();
  moved.frames[0].world_from_depth->translation_m.x() += 1;
  see(moved);
  EXPECT_TRUE(views.are_worth_fusing()) << "what it saw before is gone";
  (void)views.surfaces();
  see(moved, 3);
  EXPECT_TRUE(views.are_worth_fusing());
}

TEST_F(KeptViewsTest, sensors_without_a_pose_are_left_out) {
  FrameSet unplaced = wall_set();
  for (SetFrame& frame : unplaced.frames) frame.world_from_depth.reset();
  see(unplaced, 3);
  EXPECT_THAT(views.sensors(), IsEmpty());
}

TEST_F(KeptViewsTest, saved_views_are_the_same_again) {
  see(wall_set(), 3);
  const KeptViews::Saved saved = views.saved();
  KeptViews again{running_room_options()};
  ASSERT_TRUE(again.add_saved(saved).ok());
  EXPECT_TRUE(again.are_worth_fusing());
  const KeptViews::Saved twice = again.saved();
  ASSERT_EQ(twice.set.frames.size(), 2u);
  EXPECT_EQ(twice.set.frames[0].pictures->depth_mm.at(30, 20), 4000);
  EXPECT_EQ(twice.set.frames[1].pictures->color.at(30, 20), (Rgb8{200, 0, 0}));
  EXPECT_EQ(*twice.set.frames[1].world_from_depth, wall_pose(0));
}

}  // namespace
}  // namespace roomcast::recording
