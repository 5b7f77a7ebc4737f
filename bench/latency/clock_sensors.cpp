// SPDX-License-Identifier: Apache-2.0
#include "bench/latency/clock_sensors.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "bench/latency/capture_clock.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::bench {
namespace {

constexpr int kClockSensors = 3, kClockFrames = 45;
constexpr double kClockFps = 15;
constexpr double kAhead_m = 2;

nlohmann::json json_of_point(const RigidTransform& world_from_depth, const Eigen::Vector3d& point) {
  const Eigen::Vector3d world = world_from_depth.rotation * point + world_from_depth.translation_m;
  return {world.x(), world.y(), world.z()};
}

}  // namespace

Result<std::vector<std::unique_ptr<ReplayedSensor>>> start_clock_sensors(
    const std::string& hub_url) {
  std::vector<std::unique_ptr<ReplayedSensor>> sensors;
  for (int i = 0; i < kClockSensors; ++i) {
    auto sensor = ReplayedSensor::start(
        "sim#" + std::to_string(i), hub_url,
        {.frame_count = kClockFrames, .fps = kClockFps, .draws_clock = i == 0});
    if (!sensor) return sensor.error();
    sensors.push_back(*std::move(sensor));
  }
  return sensors;
}

std::string clock_view_json(const source::SensorDescription& clock_sensor) {
  const RigidTransform pose = clock_sensor.world_from_depth.value_or(RigidTransform());
  const CameraIntrinsics& lens = clock_sensor.calibration.depth;
  auto squares = nlohmann::json::array();
  for (int row = 0; row < kClockRows; ++row) {
    for (int column = 0; column < kClockColumns; ++column) {
      const Eigen::Vector2d pixel = clock_square(lens.width, lens.height, column, row);
      const Eigen::Vector3d straight((pixel.x() - lens.cx) / lens.fx,
                                     (pixel.y() - lens.cy) / lens.fy, 1);
      squares.push_back(
          json_of_point(pose, kAhead_m * unproject(lens, pixel, 1).value_or(straight)));
    }
  }
  return nlohmann::json{{"sensor", clock_sensor.name},
                        {"at", json_of_point(pose, Eigen::Vector3d::Zero())},
                        {"look", json_of_point(pose, {0, 0, kAhead_m})},
                        {"columns", kClockColumns},
                        {"squares", std::move(squares)}}
      .dump();
}

}  // namespace roomcast::bench
