// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/color_camera.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/geometry/registration.h"
#include "roomcast/simulator/simulated_sensor.h"

namespace roomcast::simulator {
namespace {

using std::chrono::milliseconds;

/// A grey wall at 3 m, a black board in front of it at 2 m, and one camera facing both.
simulator::Room two_walls() {
  simulator::Room room;
  room.name = "walls";
  room.size_m = {10, 4, 10};
  room.ambient = Eigen::Vector3f::Constant(0.6F);
  const auto grey =
      room.add(simulator::painted(simulator::Pattern::kPlain, 0xd0d0d0, 0xd0d0d0, 0xd0d0d0, 1));
  const auto black =
      room.add(simulator::painted(simulator::Pattern::kPlain, 0x101010, 0x101010, 0x101010, 1));
  const Eigen::Affine3f here = Eigen::Affine3f::Identity();
  simulator::add_quad(room.mesh, grey, here, {-5, -3, -3}, {10, 0, 0}, {0, 8, 0});
  simulator::add_quad(room.mesh, black, here, {-0.4F, 0.6F, -2}, {0.8F, 0, 0}, {0, 0.8F, 0});
  return room;
}

/// Subpixel position, going from `from` towards `to`, at which a row's brightness falls below the
/// mean of its end levels.
double edge_in_row(const std::vector<double>& row, int from, int to) {
  const int step = from < to ? 1 : -1;
  const double level =
      0.5 * (row[static_cast<std::size_t>(from)] + row[static_cast<std::size_t>(to)]);
  for (int x = from; x != to; x += step) {
    const double here = row[static_cast<std::size_t>(x)],
                 next = row[static_cast<std::size_t>(x + step)];
    if ((here - level) * (next - level) <= 0 && here != next)
      return x + step * (here - level) / (here - next);
  }
  return -1;
}

TEST(ColorCamera, edges_of_colour_lie_on_edges_of_depth_after_registration) {
  const simulator::Room room = two_walls();
  const auto rays = simulator::RayScene::build(room.mesh).value();
  for (const auto model : {simulator::CameraModel::kKinect2, simulator::CameraModel::kAzure,
                           simulator::CameraModel::kD435}) {
    simulator::SensingOptions options;
    options.camera = model;
    const simulator::SensorUnit unit = simulator::make_unit(options, 1, 1);
    const RigidTransform world_from_depth = world_from_optical_looking_at({0, 1, 0}, {0, 1, -3});
    const simulator::PlacedCamera depth_camera(unit.exact.depth, world_from_depth);
    const simulator::PlacedCamera fine(simulator::resampled(unit.exact.depth, 2.0),
                                       world_from_depth);
    const simulator::PlacedCamera color_camera(
        unit.exact.color, world_from_depth * unit.exact.color_from_depth.inverse());
    const auto depth = simulator::trace_depth_plate(room, *rays, depth_camera, fine, false, 0);
    const auto color = simulator::trace_color_plate(room, *rays, color_camera, 0);
    DepthImage depth_mm(depth.z_m.width(), depth.z_m.height());
    for (std::size_t i = 0; i < depth_mm.view().pixel_count(); ++i)
      depth_mm.data()[i] = static_cast<std::uint16_t>(std::lround(1000.0F * depth.z_m.data()[i]));
    RegisteredColor registered;
    auto registration = Registration::create(unit.exact).value();
    ASSERT_TRUE(registration.run(depth_mm, color.color, registered).ok());
    // The board's upper half: rows in which both pictures show both sides of the board.
    double largest = 0;
    int rows = 0;
    const int middle = static_cast<int>(unit.exact.depth.cx);
    const int reach = static_cast<int>(0.35 * unit.exact.depth.fx);
    const int centre = static_cast<int>(unit.exact.depth.cy);
    for (int y = centre - 20; y <= centre + 20; ++y) {
      std::vector<double> depths, greys;
      for (int x = 0; x < depth_mm.width(); ++x) {
        depths.push_back(depth_mm.at(x, y));
        // Pixels without colour count as wall: the test looks for the board's edge.
        greys.push_back(registered.seen.at(x, y) > 0 ? registered.color.at(x, y).g : 200.0);
      }
      for (const int to : {middle - reach, middle + reach}) {
        const double in_depth = edge_in_row(depths, middle, to);
        const double in_color = edge_in_row(greys, middle, to);
        ASSERT_GT(in_depth, 0);
        ASSERT_GT(in_color, 0);
        largest = std::max(largest, std::abs(in_depth - in_color));
        ++rows;
      }
    }
    EXPECT_EQ(rows, 82);
    EXPECT_LE(largest, 1.0) << simulator::name_of(model);
  }
}

TEST(ColorCamera, units_have_colours_of_their_own_and_exposure_follows_the_scene) {
  const auto room = SimulatedRoom::build("office", 1).value();
  std::vector<std::array<double, 3>> means;
  for (int index = 0; index < 2; ++index) {
    SimulatedSensor::Options options;
    options.index = index;
    options.sensing.half_color = true;
    const auto sensor = SimulatedSensor::open(room, options).value();
    auto moment = sensor->make_moment();
    auto control = sensor->auto_exposure();
    float least = 2, most = 0, before = 1;
    for (int i = 0; i < 150; ++i) {
      const float gain = sensor->next_exposure(milliseconds(67 * i), moment, control);
      EXPECT_NEAR(gain, before, 0.03F) << "it lags";
      before = gain;
      least = std::min(least, gain);
      most = std::max(most, gain);
    }
    EXPECT_GT(most - least, 0.001F);
    EXPECT_GT(least, 0.6F);
    EXPECT_LT(most, 1.6F);
    sensor->look(milliseconds(0), moment);
    ColorImage even, own;
    sensor->clean_color(1.0F, moment, own);
    options.sensing = options.sensing.clean();
    std::array<double, 3> mean{};
    for (std::size_t i = 0; i < own.view().pixel_count(); ++i) {
      mean[0] += own.data()[i].r;
      mean[1] += own.data()[i].g;
      mean[2] += own.data()[i].b;
    }
    means.push_back({mean[0] / mean[1], mean[1] / mean[1], mean[2] / mean[1]});
  }
  EXPECT_GT(std::abs(means[0][0] - means[1][0]) + std::abs(means[0][2] - means[1][2]), 0.005);
}

}  // namespace
}  // namespace roomcast::simulator
