// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/gone_surfaces.h"

#include <chrono>
#include <utility>

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

RoomTime at(nanoseconds since_start) {
  return RoomTime(1h + since_start);
}

/// One row of cells: near and far, in centimetres.
wire::pb::CoarseDepth cells(std::initializer_list<std::pair<std::uint32_t, std::uint32_t>> all) {
  wire::pb::CoarseDepth depth;
  depth.set_columns(static_cast<std::uint32_t>(all.size()));
  depth.set_rows(1);
  for (const auto& [near_cm, far_cm] : all) {
    depth.add_near_cm(near_cm);
    depth.add_far_cm(far_cm);
  }
  return depth;
}

TEST(GoneSurfaces, furniture_that_has_gone_wants_three_key_frames_and_no_more) {
  GoneSurfaces gone;
  gone.update(cells({{400, 400}, {250, 400}}), at(0s));
  EXPECT_FALSE(gone.wants_key(at(1s)));
  gone.update(cells({{400, 400}, {400, 400}}), at(60s));
  for (const auto key : {60s, 61s, 62s}) {
    EXPECT_TRUE(gone.wants_key(at(key)));
    gone.key_frame_came(at(key));
    EXPECT_FALSE(gone.wants_key(at(key + 100ms))) << "not at once";
  }
  EXPECT_FALSE(gone.wants_key(at(70s)));
}

TEST(GoneSurfaces, something_large_that_goes_is_said_once_and_expected_of_others) {
  GoneSurfaces gone, other;
  EXPECT_FALSE(gone.update(cells({{250, 400}, {250, 400}, {250, 400}}), at(0s)));
  EXPECT_FALSE(gone.update(cells({{400, 400}, {250, 400}, {250, 400}}), at(10s))) << "one cell";
  EXPECT_TRUE(gone.update(cells({{400, 400}, {400, 400}, {400, 400}}), at(11s)));
  EXPECT_FALSE(gone.update(cells({{400, 400}, {400, 400}, {400, 400}}), at(12s)));

  other.update(cells({{100, 500}}), at(0s));
  EXPECT_FALSE(other.wants_key(at(11s)));
  other.expect_changes();
  for (const auto key : {11s, 12s, 13s}) {
    EXPECT_TRUE(other.wants_key(at(key)));
    other.key_frame_came(at(key));
  }
  EXPECT_FALSE(other.wants_key(at(20s)));
}

TEST(GoneSurfaces, a_sensor_that_says_so_all_the_time_is_believed_every_ten_seconds) {
  GoneSurfaces gone;
  int believed = 0;
  for (int second = 0; second < 100; second += 2) {
    gone.update(cells({{250, 400}, {250, 400}, {250, 400}}), at(second * 1s));
    gone.update(cells({{1, 1}}), at(second * 1s));  // other cells: all begins anew
    gone.update(cells({{100, 100}, {100, 100}, {100, 100}}), at(second * 1s));
    believed += gone.update(cells({{400, 400}, {400, 400}, {400, 400}}), at(second * 1s + 1s));
  }
  EXPECT_EQ(believed, 10);
}

TEST(GoneSurfaces, nobody_who_walks_past_wants_key_frames) {
  GoneSurfaces gone;
  gone.update(cells({{250, 400}}), at(0s));
  for (int round = 0; round < 20; ++round) {
    gone.update(cells({{150, 250}}), at(round * 6s + 1s));
    gone.update(cells({{150, 400}}), at(round * 6s + 2s));
    gone.update(cells({{250, 400}}), at(round * 6s + 4s));
    EXPECT_FALSE(gone.wants_key(at(round * 6s + 5s)));
  }
}

TEST(GoneSurfaces, what_came_to_stand_there_can_go_too) {
  GoneSurfaces gone;
  gone.update(cells({{400, 400}}), at(0s));
  for (const auto now : {10s, 15s, 20s, 25s, 30s}) gone.update(cells({{250, 400}}), at(now));
  EXPECT_FALSE(gone.wants_key(at(30s)));
  gone.update(cells({{400, 400}}), at(40s));
  EXPECT_TRUE(gone.wants_key(at(40s)));
}

TEST(GoneSurfaces, somebody_before_the_place_postpones_the_wish) {
  GoneSurfaces gone;
  gone.update(cells({{250, 400}}), at(0s));
  gone.update(cells({{400, 400}}), at(10s));
  gone.key_frame_came(at(10s));
  gone.update(cells({{150, 400}}), at(11s));
  EXPECT_FALSE(gone.wants_key(at(11s)));
  gone.update(cells({{400, 400}}), at(14s));
  EXPECT_TRUE(gone.wants_key(at(14s)));
}

TEST(GoneSurfaces, cells_without_readings_say_nothing) {
  GoneSurfaces gone;
  gone.update(cells({{250, 400}}), at(0s));
  gone.update(cells({{0, 0}}), at(1s));
  EXPECT_FALSE(gone.wants_key(at(1s)));
  gone.update(cells({{400, 400}}), at(2s));
  EXPECT_TRUE(gone.wants_key(at(2s)));
  gone.update(cells({{300, 300}, {300, 300}}), at(3s));
  EXPECT_FALSE(gone.wants_key(at(4s))) << "another grid";
}

}  // namespace
}  // namespace roomcast::hub
