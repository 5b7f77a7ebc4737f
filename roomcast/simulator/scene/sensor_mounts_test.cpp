// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/sensor_mounts.h"

#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/simulator/tracing/placed_camera.h"
#include "roomcast/simulator/tracing/ray_scene.h"

namespace roomcast::simulator {
namespace {

using Cell = std::tuple<int, int, int>;

struct Sight {
  std::set<Cell> cells;  // seen surface cells of a quarter metre
  int rays = 0;
  int near_rays = 0;  // rays that end within 80 cm of the sensor
};

/// The view of a camera with a Kinect's field of view.
Sight look_from(const SensorMount& mount, const RayScene& scene) {
  CameraIntrinsics lens;
  lens.width = 64;
  lens.height = 53;
  lens.fx = lens.fy = 46.0;
  lens.cx = 31.5;
  lens.cy = 26.0;
  const PlacedCamera camera(lens, world_from_optical_looking_at(mount.eye_m.cast<double>(),
                                                                mount.target_m.cast<double>()));
  Sight sight;
  for (int y = 0; y < lens.height; ++y) {
    for (int x = 0; x < lens.width; ++x) {
      const auto hit = scene.first_hit(camera.eye_m(), camera.direction(x, y));
      if (!hit) continue;
      ++sight.rays;
      if (hit->t < 0.8F) ++sight.near_rays;
      const Eigen::Vector3f cell = (4.0F * camera.point(x, y, hit->t)).array().floor();
      sight.cells.emplace(static_cast<int>(cell.x()), static_cast<int>(cell.y()),
                          static_cast<int>(cell.z()));
    }
  }
  return sight;
}

TEST(SensorMounts, every_sensor_sees_much_of_the_room_and_nothing_close_up) {
  for (const std::string_view name : kSceneNames) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Room room = build_room(name, seed).value();
      const auto scene = *RayScene::build(room.mesh);
      for (const SensorMount& mount : room.sensor_mounts) {
        const Sight sight = look_from(mount, *scene);
        EXPECT_EQ(sight.rays, 64 * 53) << name << " " << seed;
        EXPECT_LT(sight.near_rays, 64 * 53 / 4) << name << " " << seed;
        EXPECT_GT(sight.cells.size(), 150U) << name << " " << seed;
      }
    }
  }
}

TEST(SensorMounts, any_two_of_the_first_four_overlap) {
  for (const std::string_view name : kSceneNames) {
    const Room room = build_room(name, 1).value();
    const auto scene = *RayScene::build(room.mesh);
    std::array<std::set<Cell>, 4> seen;
    for (std::size_t i = 0; i < seen.size(); ++i)
      seen[i] = look_from(room.sensor_mounts[i], *scene).cells;
    for (std::size_t a = 0; a < seen.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        std::size_t shared = 0;
        for (const Cell& cell : seen[a]) shared += seen[b].count(cell);
        EXPECT_GT(shared, seen[a].size() / 12) << name << ": " << a << " and " << b;
      }
    }
  }
}

TEST(SensorMounts, those_in_corners_are_high_up_and_face_each_other) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    const Stands sensor_mounts = draw_sensor_mounts_in_corners({5.0F, 2.5F, 4.2F}, random);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_GE(sensor_mounts[i].eye_m.y(), 1.9F);
      EXPECT_LE(sensor_mounts[i].eye_m.y(), 2.1F);
      const Eigen::Vector3f& other = sensor_mounts[(i + 2) % 4].eye_m;
      const Eigen::Vector3f gaze =
          (sensor_mounts[i].target_m - sensor_mounts[i].eye_m).normalized();
      EXPECT_GT(gaze.dot((other - sensor_mounts[i].eye_m).normalized()), 0.75F);
    }
  }
}

}  // namespace
}  // namespace roomcast::simulator
