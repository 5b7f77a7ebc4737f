// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/free_view.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

using std::chrono::milliseconds;

CameraIntrinsics small_lens() {
  CameraIntrinsics lens;
  lens.width = lens.height = 160;
  lens.fx = lens.fy = 80;
  lens.cx = lens.cy = 79.5;
  return lens;
}

class FreeViews : public testing::Test {
 protected:
  FreeViews() {
    for (int i = 0; i < 2; ++i) {
      SimulatedSensor::Options options;
      options.index = i;
      options.sensing = simulator::SensingOptions().clean();
      options.sensing.half_color = true;
      sensors_.push_back(SimulatedSensor::open(room_, options).value());
      pointers_.push_back(sensors_.back().get());
    }
  }

  std::vector<DepthImage> depths_at(nanoseconds time) const {
    std::vector<DepthImage> depths;
    for (const auto& sensor : sensors_) {
      auto moment = sensor->make_moment();
      sensor->look(time, moment);
      depths.push_back(sensor->clean_depth_mm(moment));
    }
    return depths;
  }

  std::shared_ptr<const SimulatedRoom> room_ = SimulatedRoom::build("livingroom", 1).value();
  std::vector<std::unique_ptr<SimulatedSensor>> sensors_;
  std::vector<const SimulatedSensor*> pointers_;
};

TEST_F(FreeViews, viewpoints_are_apart_in_the_room_and_the_same_for_the_same_seed) {
  const auto places = free_viewpoints(*room_, pointers_, 4, 1);
  ASSERT_GE(places.size(), 3U);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_LT((places[i].translation_m.array().abs() -
               0.5 * room_->room().size_m.cast<double>().array() * Eigen::Array3d(1, 2, 1))
                  .maxCoeff(),
              -0.3);
    EXPECT_GT(places[i].translation_m.y(), 1.2);
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT((places[i].translation_m - places[j].translation_m).norm(), 1.0);
  }
  const auto again = free_viewpoints(*room_, pointers_, 4, 1);
  ASSERT_EQ(again.size(), places.size());
  EXPECT_EQ(again[0].translation_m, places[0].translation_m);
  EXPECT_NE(free_viewpoints(*room_, pointers_, 4, 2)[0].translation_m, places[0].translation_m);
}

TEST_F(FreeViews, depth_is_the_distance_to_the_room_and_the_people) {
  const auto places = free_viewpoints(*room_, pointers_, 1, 1);
  FreeView view(*room_, small_lens(), places[0], 0);
  simulator::MovingThings things(room_->room());
  things.move_to(milliseconds(500));
  view.look(things);
  const simulator::PlacedCamera camera(small_lens(), places[0]);
  int nearer = 0;
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 160; ++x) {
      const auto hit = room_->rays().first_hit(camera.eye_m(), camera.direction(x, y));
      ASSERT_TRUE(hit);
      const double still_mm = 1000.0 * static_cast<double>(hit->t);
      EXPECT_LE(view.depth_mm().at(x, y), still_mm + 1.0);
      nearer += view.depth_mm().at(x, y) < still_mm - 1.0;
    }
  }
  EXPECT_LT(nearer, 160 * 160 / 2);
}

TEST_F(FreeViews, a_sensors_own_view_is_seen_by_it_nearly_everywhere) {
  const auto depths = depths_at(milliseconds(500));
  FreeView view(*room_, small_lens(), sensors_[0]->world_from_depth(), 0);
  simulator::MovingThings things(room_->room());
  things.move_to(milliseconds(500));
  view.look(things);
  const MaskImage seen = view.seen_by(pointers_, depths);
  int by_first = 0, by_second = 0, all = 0;
  for (int y = 50; y < 110; ++y) {
    for (int x = 40; x < 120; ++x, ++all) {
      by_first += (seen.at(x, y) & 1U) != 0;
      by_second += (seen.at(x, y) & 2U) != 0;
    }
  }
  EXPECT_GT(by_first, all * 97 / 100);
  EXPECT_GT(by_second, all / 10);
  EXPECT_LT(by_second, all * 95 / 100);
}

}  // namespace
}  // namespace roomcast::simulator
