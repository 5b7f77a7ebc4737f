// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/interference_advice.h"

#include <cmath>
#include <string>

#include <Eigen/Core>

namespace roomcast::hub {
namespace {

constexpr double kFarthestLight_m = 6;
constexpr double kMinShared = 0.05;  // of the view; a neighbour that lights less is not to blame
constexpr int kColumns = 12, kRows = 9;

Eigen::Vector3d point_in_view(const wire::pb::Intrinsics& lens, int column, int row, double z_m) {
  const double x = (column + 0.5) / kColumns * lens.width(),
               y = (row + 0.5) / kRows * lens.height();
  return z_m * Eigen::Vector3d((x - lens.cx()) / lens.fx(), (y - lens.cy()) / lens.fy(), 1);
}

bool sees(const wire::pb::Intrinsics& lens, const Eigen::Vector3d& point_m) {
  if (point_m.z() < 0.2 || point_m.z() > kFarthestLight_m) return false;
  const double x = lens.fx() * point_m.x() / point_m.z() + lens.cx();
  const double y = lens.fy() * point_m.y() / point_m.z() + lens.cy();
  return x >= 0 && y >= 0 && x < lens.width() && y < lens.height();
}

bool has_lens(const RoomSensor& sensor) {
  const auto& lens = sensor.description.calibration().depth();
  return lens.width() > 0 && lens.height() > 0 && lens.fx() > 0 && lens.fy() > 0;
}

bool may_disturb(const RoomSensor& sensor, const RoomSensor& other) {
  return other.id != sensor.id && other.connection && other.pose.is_placed() && has_lens(other);
}

std::string percent(double share) {
  return std::to_string(std::lround(100 * share)) + " %";
}

std::string advice_for(const SensorInterference& disturbed) {
  const bool flickers = disturbed.flickering >= kDisturbedFlickering;
  if (!flickers && disturbed.noise_ratio < kDisturbedNoiseRatio) return {};
  const bool is_known = !disturbed.neighbour.empty();
  const std::string who =
      is_known ? "\"" + disturbed.neighbour + "\" lights " + percent(disturbed.shared) +
                     " of what this sensor sees"
               : std::string("Another infrared camera or the sun lights what this sensor sees");
  const std::string turn =
      is_known ? " Turn one of the two so that they light fewer surfaces together, or move \"" +
                     disturbed.neighbour + "\" away from those surfaces."
               : " Place the sensors, then this page can say which one it is.";
  const std::string share_time =
      " Cameras with a sync cable should take turns: roomcast sensor --sync primary on one, --sync "
      "secondary --trigger-delay-us 160 on the other.";
  return who + "." + turn + share_time;
}

}  // namespace

double shared_view(const RoomSensor& sensor, const RoomSensor& other) {
  const auto& lens = sensor.description.calibration().depth();
  const auto& other_lens = other.description.calibration().depth();
  const RigidTransform other_from_sensor =
      other.pose.world_from_depth.inverse() * sensor.pose.world_from_depth;
  int points = 0, shared = 0;
  for (const double z_m : {1.0, 1.75, 2.5, 3.25, 4.0}) {
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kColumns; ++column) {
        ++points;
        shared += sees(other_lens, other_from_sensor * point_in_view(lens, column, row, z_m));
      }
    }
  }
  return static_cast<double>(shared) / points;
}

std::optional<SensorInterference> interference_of(const RoomSensor& sensor, const SensorList& all) {
  if (!sensor.connection || !sensor.health) return std::nullopt;
  SensorInterference disturbed;
  disturbed.flickering = static_cast<double>(sensor.health->flickering());
  disturbed.noise_ratio = static_cast<double>(sensor.health->noise_ratio());
  if (sensor.pose.is_placed() && has_lens(sensor)) {
    for (const RoomSensor& other : all.all()) {
      if (!may_disturb(sensor, other)) continue;
      const double shared = shared_view(sensor, other);
      if (shared < kMinShared || shared <= disturbed.shared) continue;
      disturbed.shared = shared;
      disturbed.neighbour = other.name;
    }
  }
  disturbed.advice = advice_for(disturbed);
  return disturbed;
}

}  // namespace roomcast::hub
