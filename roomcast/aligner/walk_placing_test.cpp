// SPDX-License-Identifier: Apache-2.0
#include "roomcast/aligner/walk_placing.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::aligner {
namespace {

constexpr double kHeadRadius_m = 0.06;

Eigen::Vector3d stroll(double time_s) {
  const double angle = 0.5 * time_s + 0.8 * std::sin(0.45 * time_s);
  return {1.1 * std::cos(angle), 1.7, 0.8 * std::sin(angle) + 0.2 * std::sin(2.2 * angle)};
}

struct Sensor {
  std::string name;
  RigidTransform world_from_depth;

  [[nodiscard]] align::Plane floor() const {
    const Eigen::Vector3d up = world_from_depth.rotation.transpose() * Eigen::Vector3d::UnitY();
    return {up.cast<float>(), static_cast<float>(world_from_depth.translation_m.y()), {}};
  }
  [[nodiscard]] wire::pb::Sightings of_stroll() const {
    wire::pb::Sightings seen;
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d head = world_from_depth.inverse() * stroll(0.1 * i);
      const Eigen::Vector3d surface = head - kHeadRadius_m * head.normalized();
      auto& sighting = *seen.add_heads();
      sighting.set_room_ns(1'000'000'000'000ULL + 100'000'000ULL * static_cast<unsigned>(i));
      sighting.set_x(static_cast<float>(surface.x()));
      sighting.set_y(static_cast<float>(surface.y()));
      sighting.set_z(static_cast<float>(surface.z()));
    }
    return seen;
  }
};

const Sensor kLeft{"left", world_from_optical_looking_at({-2.5, 2, 0.3}, {0, 1, 0})};
const Sensor kRight{"right", world_from_optical_looking_at({2.5, 1.8, -0.2}, {0, 1, 0})};

WalkPlacing watched_by(std::initializer_list<const Sensor*> sensors) {
  WalkPlacing placing;
  for (const Sensor* sensor : sensors) {
    placing.stand(sensor->name, sensor->floor());
    placing.see(sensor->name, sensor->of_stroll());
  }
  return placing;
}

TEST(WalkPlacing, a_lost_sensor_is_placed_beside_one_that_is_not) {
  const auto placing = watched_by({&kLeft, &kRight});
  const auto found = placing.place({{"left", kLeft.world_from_depth}}, {"right"});
  ASSERT_EQ(found.size(), 1U);
  ASSERT_TRUE(found[0].world_from_depth) << found[0].note;
  EXPECT_LT(
      (found[0].world_from_depth->translation_m - kRight.world_from_depth.translation_m).norm(),
      0.05);
  EXPECT_GT(found[0].expected_error_mm, 5);
}

TEST(WalkPlacing, where_nobody_is_placed_the_first_makes_the_world) {
  const auto found = watched_by({&kLeft, &kRight}).place({}, {"left", "right"});
  ASSERT_EQ(found.size(), 2U);
  ASSERT_TRUE(found[0].world_from_depth && found[1].world_from_depth);
  const RigidTransform between = found[0].world_from_depth->inverse() * *found[1].world_from_depth;
  const RigidTransform truth = kLeft.world_from_depth.inverse() * kRight.world_from_depth;
  EXPECT_LT((between.translation_m - truth.translation_m).norm(), 0.05);
}

TEST(WalkPlacing, one_that_is_alone_stands_nowhere) {
  for (const auto& placement : watched_by({&kLeft}).place({}, {"left", "right"}))
    EXPECT_FALSE(placement.world_from_depth);
}

TEST(WalkPlacing, what_was_seen_before_it_was_moved_does_not_count) {
  auto placing = watched_by({&kLeft, &kRight});
  placing.stand("right", kRight.floor());
  EXPECT_TRUE(placing.place({{"left", kLeft.world_from_depth}}, {"right"}).empty());
}

TEST(WalkPlacing, a_sensor_that_sees_no_floor_takes_no_part) {
  auto placing = watched_by({&kLeft});
  placing.stand("right", std::nullopt);
  placing.see("right", kRight.of_stroll());
  EXPECT_TRUE(placing.place({{"left", kLeft.world_from_depth}}, {"right"}).empty());
}

}  // namespace
}  // namespace roomcast::aligner
