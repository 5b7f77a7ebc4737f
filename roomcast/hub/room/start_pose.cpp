// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/start_pose.h"

#include <cmath>

namespace roomcast::hub {
namespace {

constexpr double kEyeHeight_m = 1.6;
constexpr double kLookAtHeight_m = 1.0;
constexpr double kSubjectDistance_m = 2.5;  // typical of indoor depth sensors
constexpr double kElbowRoom_m = 0.6;
constexpr double kStepTowardsSubject =
    0.15;  // share of the distance: the viewer starts in front of the sensor, not inside it

struct OnFloor {
  double x = 0, z = 0;
};

OnFloor position(const Matrix4& m) {
  return {m[3], m[11]};
}

/// The centre of the points that the sensors look at.
OnFloor subject(std::span<const Matrix4> world_from_depth) {
  OnFloor sum;
  for (const Matrix4& m : world_from_depth) {
    sum.x += m[3] + kSubjectDistance_m * m[2];  // third column: the optical axis
    sum.z += m[11] + kSubjectDistance_m * m[10];
  }
  const auto count = static_cast<double>(world_from_depth.size());
  return {sum.x / count, sum.z / count};
}

Matrix4 looking(OnFloor eye, OnFloor at) {
  const double dx = at.x - eye.x, dy = kLookAtHeight_m - kEyeHeight_m, dz = at.z - eye.z;
  const double level = std::hypot(dx, dz), length = std::hypot(level, dy);
  const bool nowhere = level < 1e-6;
  // forward f, right r = f x up, up u = r x f
  const double fx = nowhere ? 0 : dx / length, fy = nowhere ? 0 : dy / length,
               fz = nowhere ? -1 : dz / length;
  const double across = std::hypot(fx, fz);
  const double rx = -fz / across, rz = fx / across;
  const double ux = -rz * fy, uy = rz * fx - rx * fz, uz = rx * fy;
  return {rx, ux, -fx, eye.x, 0, uy, -fy, kEyeHeight_m, rz, uz, -fz, eye.z, 0, 0, 0, 1};
}

}  // namespace

Matrix4 start_pose(std::span<const Matrix4> world_from_depth, std::size_t index) {
  if (world_from_depth.empty()) {
    return looking({kElbowRoom_m * static_cast<double>(index), 0},
                   {kElbowRoom_m * static_cast<double>(index), -1});
  }
  const OnFloor at = subject(world_from_depth);
  const OnFloor sensor = position(world_from_depth[index % world_from_depth.size()]);
  const double toward_x = at.x - sensor.x, toward_z = at.z - sensor.z;
  const double distance = std::hypot(toward_x, toward_z);
  const double aside = kElbowRoom_m * static_cast<double>(index / world_from_depth.size());
  OnFloor eye{sensor.x + kStepTowardsSubject * toward_x, sensor.z + kStepTowardsSubject * toward_z};
  if (distance > 1e-6) {
    eye.x += aside * -toward_z / distance;
    eye.z += aside * toward_x / distance;
  }
  return looking(eye, at);
}

}  // namespace roomcast::hub
