// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/depth_camera.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/simulator/simulated_sensor.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector3d;
using std::chrono::milliseconds;

/// Sensors without errors, which report true depth.
SimulatedSensor::Options perfect(int index) {
  SimulatedSensor::Options options;
  options.index = index;
  options.sensing = simulator::SensingOptions().clean();
  options.sensing.half_color = true;
  return options;
}

/// The room and everything in it at an instant, as one mesh.
simulator::TriangleMesh whole_mesh(const simulator::Room& room, nanoseconds time) {
  simulator::MovingThings things(room);
  things.move_to(time);
  simulator::TriangleMesh mesh = room.mesh;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const simulator::TriangleMesh& moving = things.mesh();
  mesh.positions.insert(mesh.positions.end(), moving.positions.begin(), moving.positions.end());
  mesh.normals.insert(mesh.normals.end(), moving.normals.begin(), moving.normals.end());
  mesh.uv_m.insert(mesh.uv_m.end(), moving.uv_m.begin(), moving.uv_m.end());
  for (const auto& corner : moving.triangles)
    mesh.triangles.push_back({first + corner[0], first + corner[1], first + corner[2]});
  mesh.surface.insert(mesh.surface.end(), moving.surface.begin(), moving.surface.end());
  return mesh;
}

TEST(DepthCamera, drawing_moving_things_over_the_static_room_equals_a_full_trace) {
  const auto room = SimulatedRoom::build("office", 1).value();
  for (const int index : {0, 2}) {
    const auto sensor = SimulatedSensor::open(room, perfect(index)).value();
    auto moment = sensor->make_moment();
    for (const auto time : {milliseconds(0), milliseconds(3700)}) {
      sensor->look(time, moment);
      const DepthImage& drawn = sensor->clean_depth_mm(moment);
      const simulator::TriangleMesh mesh = whole_mesh(room->room(), time);
      const auto rays = simulator::RayScene::build(mesh).value();
      const simulator::PlacedCamera& camera = sensor->depth_camera().placed();
      int differing = 0, moving_seen = 0;
      const auto still = static_cast<std::uint32_t>(room->room().mesh.triangles.size());
      for (int y = 0; y < drawn.height(); ++y) {
        for (int x = 0; x < drawn.width(); ++x) {
          const auto hit = rays->first_hit(camera.eye_m(), camera.direction(x, y));
          const double traced_mm = hit ? 1000.0 * static_cast<double>(hit->t) : 0.0;
          moving_seen += hit && hit->triangle >= still;
          differing += std::abs(drawn.at(x, y) - traced_mm) > 1.0;
        }
      }
      EXPECT_GT(moving_seen, 500);
      // Rays that graze an edge may hit either surface.
      EXPECT_LE(differing, 1 + moving_seen / 500) << "sensor " << index;
    }
  }
}

/// |dz| in millimetres between the surfaces seen by `from` and `to`, for pixels whose point the
/// other camera sees within 5 cm.
std::vector<double> disagreement_mm(const SimulatedSensor& from, const DepthImage& from_mm,
                                    const SimulatedSensor& to, const DepthImage& to_mm) {
  const RigidTransform to_from_from = to.world_from_depth().inverse() * from.world_from_depth();
  const CameraIntrinsics& lens = to.exact_calibration().depth;
  std::vector<double> differences;
  for (int y = 0; y < from_mm.height(); y += 2) {
    for (int x = 0; x < from_mm.width(); x += 2) {
      const double z_m = 1e-3 * from_mm.at(x, y);
      const auto point = unproject(from.exact_calibration().depth, Eigen::Vector2d(x, y), z_m);
      if (z_m == 0 || !point) continue;
      const Vector3d there = to_from_from * *point;
      const auto pixel = project(lens, there);
      if (!pixel) continue;
      const int u = static_cast<int>(std::lround(pixel->x())),
                v = static_cast<int>(std::lround(pixel->y()));
      if (u < 1 || v < 1 || u + 1 >= lens.width || v + 1 >= lens.height) continue;
      // Interpolated between the four pixels around it.
      const int left = static_cast<int>(pixel->x()), top = static_cast<int>(pixel->y());
      const double a = pixel->x() - left, b = pixel->y() - top;
      const double seen_mm =
          (1 - b) * ((1 - a) * to_mm.at(left, top) + a * to_mm.at(left + 1, top)) +
          b * ((1 - a) * to_mm.at(left, top + 1) + a * to_mm.at(left + 1, top + 1));
      const double difference = std::abs(seen_mm - 1000.0 * there.z());
      if (difference < 50.0) differences.push_back(difference);
    }
  }
  return differences;
}

TEST(DepthCamera, sensors_agree_within_a_millimetre_on_common_surfaces) {
  const auto room = SimulatedRoom::build("livingroom", 1).value();
  std::vector<std::unique_ptr<SimulatedSensor>> sensors;
  std::vector<DepthImage> seen;
  for (int i = 0; i < 3; ++i) {
    sensors.push_back(SimulatedSensor::open(room, perfect(i)).value());
    auto moment = sensors.back()->make_moment();
    sensors.back()->look(milliseconds(1500), moment);
    seen.push_back(sensors.back()->clean_depth_mm(moment));
  }
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      if (a == b) continue;
      auto differences = disagreement_mm(*sensors[a], seen[a], *sensors[b], seen[b]);
      ASSERT_GT(differences.size(), 2000U);
      const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
      std::nth_element(differences.begin(), middle, differences.end());
      EXPECT_LT(*middle, 1.0) << "s" << a << " in s" << b;
    }
  }
}

TEST(DepthCamera, noise_of_the_empty_room_does_not_depend_on_the_people) {
  const auto room = SimulatedRoom::build("office", 1).value();
  SimulatedSensor::Options options = perfect(0);
  options.sensing = {};
  options.sensing.half_color = true;
  const auto sensor = SimulatedSensor::open(room, options).value();
  auto moment = sensor->make_moment();
  DepthImage first, second;
  MaskImage moving, moving_then;
  sensor->look(milliseconds(0), moment);
  sensor->read_depth(4, moment, first);
  sensor->mark_moving(moment, moving);
  sensor->look(milliseconds(4000), moment);
  sensor->read_depth(4, moment, second);
  sensor->mark_moving(moment, moving_then);
  int differing = 0;
  for (int y = 1; y + 1 < first.height(); ++y) {
    for (int x = 1; x + 1 < first.width(); ++x) {
      bool near = false;  // within a pixel of a moving thing
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx)
          near = near || moving.at(x + dx, y + dy) > 0 || moving_then.at(x + dx, y + dy) > 0;
      }
      if (!near) differing += first.at(x, y) != second.at(x, y);
    }
  }
  // A part thinner than a pixel may appear in a sample without covering any pixel's centre.
  EXPECT_LE(differing, 20);
}

TEST(DepthCamera, the_expected_reading_is_the_mean_of_many) {
  const auto room = SimulatedRoom::build("office", 1).value();
  SimulatedSensor::Options options;
  options.sensing.half_color = true;
  const auto sensor = SimulatedSensor::open(room, options).value();
  auto moment = sensor->make_moment();
  sensor->look(milliseconds(3700), moment);
  DepthImage expected, reading;
  sensor->expected_depth(moment, expected);
  constexpr int kReadings = 20;
  std::vector<double> sum(expected.view().pixel_count());
  std::vector<int> count(sum.size());
  for (int i = 0; i < kReadings; ++i) {
    sensor->read_depth(static_cast<std::uint64_t>(i), moment, reading);
    for (std::size_t k = 0; k < sum.size(); ++k) {
      sum[k] += reading.data()[k];
      count[k] += reading.data()[k] != 0;
    }
  }
  std::size_t certain = 0, differing = 0;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    if (count[k] < kReadings) continue;  // next to an edge, or too dark
    ++certain;
    differing += std::abs(sum[k] / kReadings - expected.data()[k]) > 5;
  }
  EXPECT_GT(certain, sum.size() / 2);
  EXPECT_LT(differing, certain / 20);
  const DepthImage& truth = sensor->clean_depth_mm(moment);
  std::size_t biased = 0;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    biased += expected.data()[k] != 0 && std::abs(expected.data()[k] - truth.data()[k]) > 5;
  }
  EXPECT_GT(biased, sum.size() / 100) << "it has the sensor's systematic errors";
}

}  // namespace
}  // namespace roomcast::simulator
