// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/tracing/static_plate.h"

#include <cmath>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "roomcast/simulator/sensing/sensor_unit.h"

namespace roomcast::simulator {
namespace {

constexpr float kTolerance_m = 0.001F;

CameraIntrinsics depth_lens(int sensor) {
  return make_unit({}, 1, sensor).exact.depth;
}

PlacedCamera depth_camera(const Room& room, int sensor) {
  const SensorMount& stand = room.sensor_mounts[static_cast<std::size_t>(sensor)];
  return {depth_lens(sensor),
          world_from_optical_looking_at(stand.eye_m.cast<double>(), stand.target_m.cast<double>())};
}

struct View {
  Room room = build_room("livingroom", 1).value();
  std::unique_ptr<RayScene> scene = *RayScene::build(room.mesh);
};

TEST(StaticPlate, floor_and_walls_lie_where_their_planes_are) {
  const View view;
  for (int sensor = 0; sensor < 3; ++sensor) {
    const PlacedCamera camera = depth_camera(view.room, sensor);
    const PlacedCamera fine(resampled(depth_lens(sensor), 2.0), camera.world_from_camera());
    const DepthPlate plate = trace_depth_plate(view.room, *view.scene, camera, fine, true, 0);
    int floor = 0, walls = 0;
    for (int y = 0; y < camera.height(); ++y) {
      for (int x = 0; x < camera.width(); ++x) {
        const auto hit = view.scene->first_hit(camera.eye_m(), camera.direction(x, y));
        ASSERT_TRUE(hit);
        const auto surface = view.room.mesh.surface[hit->triangle];
        const Eigen::Vector3f direction = camera.direction(x, y);
        const float to_floor = -camera.eye_m().y() / direction.y();
        const float to_x_wall = (0.5F * view.room.size_m.x() - camera.eye_m().x()) / direction.x();
        if (surface == 0) {  // order of the room's surfaces: floor, ceiling, skirting, walls
          EXPECT_NEAR(plate.z_m.at(x, y), to_floor, kTolerance_m);
          ++floor;
        } else if (surface == 4 && hit->normal.x() < -0.99F) {
          EXPECT_NEAR(plate.z_m.at(x, y), to_x_wall, kTolerance_m);
          ++walls;
        }
      }
    }
    EXPECT_GT(floor, 5000) << "sensor " << sensor;
    EXPECT_GE(walls, sensor == 0 ? 2000 : 0) << "sensor " << sensor;
  }
}

TEST(StaticPlate, every_pixel_of_every_sensor_sees_a_surface_in_range) {
  for (const char* name : {"livingroom", "office"}) {
    const Room room = build_room(name, 1).value();
    const auto scene = *RayScene::build(room.mesh);
    for (int sensor = 0; sensor < kMaxSimulatedSensors; ++sensor) {
      const PlacedCamera camera = depth_camera(room, sensor);
      for (int y = 0; y < camera.height(); y += 4) {
        for (int x = 0; x < camera.width(); x += 4) {
          const auto hit = scene->first_hit(camera.eye_m(), camera.direction(x, y));
          ASSERT_TRUE(hit) << name << " sensor " << sensor;
          EXPECT_LT(hit->t, 8.0F);
        }
      }
      const auto middle = scene->first_hit(camera.eye_m(), camera.direction(256, 212));
      EXPECT_GT(middle->t, 1.5F) << name << " sensor " << sensor
                                 << " looks at something right in front of it";
    }
  }
}

using PlateCell = std::tuple<int, int, int>;

/// The room's surface cells of 10 cm that the sensor sees.
std::set<PlateCell> cells_seen(const Room& room, const RayScene& scene, int sensor) {
  const PlacedCamera camera = depth_camera(room, sensor);
  std::set<PlateCell> cells;
  for (int y = 0; y < camera.height(); y += 2) {
    for (int x = 0; x < camera.width(); x += 2) {
      const auto hit = scene.first_hit(camera.eye_m(), camera.direction(x, y));
      if (!hit) continue;
      const Eigen::Vector3f cell = (camera.point(x, y, hit->t) * 10.0F).array().floor();
      cells.emplace(static_cast<int>(cell.x()), static_cast<int>(cell.y()),
                    static_cast<int>(cell.z()));
    }
  }
  return cells;
}

TEST(StaticPlate, three_sensors_overlap_and_each_sees_surfaces_of_its_own) {
  for (const char* name : {"livingroom", "office"}) {
    const Room room = build_room(name, 1).value();
    const auto scene = *RayScene::build(room.mesh);
    std::array<std::set<PlateCell>, 3> seen;
    for (int sensor = 0; sensor < 3; ++sensor) {
      seen[static_cast<std::size_t>(sensor)] = cells_seen(room, *scene, sensor);
    }
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& first = seen[(a + 1) % 3];
      const auto& second = seen[(a + 2) % 3];
      double alone = 0, shared = 0;
      for (const PlateCell& cell : seen[a]) {
        const bool others = first.count(cell) > 0 || second.count(cell) > 0;
        ++(others ? shared : alone);
      }
      const double all = static_cast<double>(seen[a].size());
      EXPECT_GT(alone / all, 0.10) << name << " sensor " << a;
      EXPECT_GT(shared / all, 0.25) << name << " sensor " << a;
    }
  }
}

}  // namespace
}  // namespace roomcast::simulator
