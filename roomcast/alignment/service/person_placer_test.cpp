// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/person_placer.h"

#include <gtest/gtest.h>

#include "roomcast/alignment/person/head_detector.h"
#include "roomcast/alignment/service/walk_fixture.h"

namespace roomcast::alignment {
namespace {

constexpr double kInside_m = 0.06;

struct Sensor {
  std::string name;
  RigidTransform world_from_depth;

  [[nodiscard]] alignment::Plane floor() const {
    const Eigen::Vector3d up = world_from_depth.rotation.transpose() * Eigen::Vector3d::UnitY();
    return {up.cast<float>(), static_cast<float>(world_from_depth.translation_m.y()), {}};
  }
  [[nodiscard]] wire::pb::Sightings of_stroll() const {
    return stroll_seen_from(world_from_depth, kInside_m);
  }
};

const Sensor kLeft{"left", world_from_optical_looking_at({-2.5, 2, 0.3}, {0, 1, 0})};
const Sensor kRight{"right", world_from_optical_looking_at({2.5, 1.8, -0.2}, {0, 1, 0})};

Seeds seeds() {
  return {{"left", alignment::level_from_depth(kLeft.floor())},
          {"right", alignment::level_from_depth(kRight.floor())}};
}

Placement as_found(Placement found, const KnownPoses&) {
  return found;
}

PersonPlacer watched_by(std::initializer_list<const Sensor*> sensors) {
  PersonPlacer placing;
  for (const Sensor* sensor : sensors) {
    placing.set_floor(sensor->name, sensor->floor());
    placing.see(sensor->name, sensor->of_stroll());
  }
  return placing;
}

TEST(PersonPlacer, a_lost_sensor_is_placed_beside_one_that_is_not) {
  const auto placing = watched_by({&kLeft, &kRight});
  const auto found = placing.place({{"left", kLeft.world_from_depth}}, {"right"}, {}, as_found);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_TRUE(found[0].pose.is_placed()) << found[0].pose.note;
  EXPECT_LT(
      (found[0].pose.world_from_depth.translation_m - kRight.world_from_depth.translation_m).norm(),
      0.05);
  EXPECT_GT(found[0].pose.expected_error_mm, 5);
}

TEST(PersonPlacer, where_nobody_is_placed_the_first_makes_the_world) {
  const auto found = watched_by({&kLeft, &kRight}).place({}, {"left", "right"}, seeds(), as_found);
  ASSERT_EQ(found.size(), 2U);
  ASSERT_TRUE(found[0].pose.is_placed() && found[1].pose.is_placed());
  ASSERT_EQ(found[1].sensor, "left") << "it made the world";
  const RigidTransform between =
      found[1].pose.world_from_depth.inverse() * found[0].pose.world_from_depth;
  const RigidTransform truth = kLeft.world_from_depth.inverse() * kRight.world_from_depth;
  EXPECT_LT((between.translation_m - truth.translation_m).norm(), 0.05);
}

TEST(PersonPlacer, one_who_saw_nobody_makes_no_world) {
  Seeds with_a_blind_one = {{"a", RigidTransform()}};
  for (const auto& seed : seeds()) with_a_blind_one.push_back(seed);
  const auto found =
      watched_by({&kLeft, &kRight}).place({}, {"a", "left", "right"}, with_a_blind_one, as_found);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].sensor, "left");
  EXPECT_TRUE(found[0].pose.is_placed());
}

TEST(PersonPlacer, what_is_found_is_refined_beside_those_that_are_placed) {
  const auto refine = [](const Placement& found, const KnownPoses& placed) {
    EXPECT_EQ(found.sensor, "right");
    EXPECT_TRUE(placed.contains("left"));
    return placed_at("right", kRight.world_from_depth, 3);
  };
  const auto found = watched_by({&kLeft, &kRight})
                         .place({{"left", kLeft.world_from_depth}}, {"right"}, {}, refine);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].pose.world_from_depth.translation_m, kRight.world_from_depth.translation_m);
  EXPECT_EQ(found[0].pose.expected_error_mm, 3);
}

TEST(PersonPlacer, one_that_is_alone_stands_nowhere) {
  for (const auto& placement : watched_by({&kLeft}).place({}, {"left", "right"}, seeds(), as_found))
    EXPECT_FALSE(placement.pose.is_placed());
}

TEST(PersonPlacer, what_was_seen_before_it_was_moved_does_not_count) {
  auto placing = watched_by({&kLeft, &kRight});
  placing.set_floor("right", kRight.floor());
  EXPECT_TRUE(placing.place({{"left", kLeft.world_from_depth}}, {"right"}, {}, as_found).empty());
}

TEST(PersonPlacer, a_sensor_that_sees_no_floor_takes_no_part) {
  auto placing = watched_by({&kLeft});
  placing.set_floor("right", std::nullopt);
  placing.see("right", kRight.of_stroll());
  EXPECT_TRUE(placing.place({{"left", kLeft.world_from_depth}}, {"right"}, {}, as_found).empty());
}

}  // namespace
}  // namespace roomcast::alignment
