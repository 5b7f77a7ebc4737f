// SPDX-License-Identifier: Apache-2.0
// SeenSurface: where the surfaces are that a sensor sees, as a few points in the world. Pure.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/ids.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// Another sensor that sees a point, too.
struct OtherView {
  SensorId sensor;
  Eigen::Vector3f to_sensor;  // unit vector
};

struct SurfacePoint {
  Eigen::Vector3f at_m;       // world frame
  Eigen::Vector3f to_sensor;  // unit vector
  std::vector<OtherView> others = {};
  bool moves = false;  // its distance has changed lately
};

/// A sensor's view, by which it is known which points of other sensors' surfaces it sees, too.
struct SensorSight {
  wire::pb::CoarseDepth depth;
  wire::pb::Intrinsics lens;
  RigidTransform world_from_depth;

  /// Whether a point of the world, metres, lies about where this sensor sees a surface.
  [[nodiscard]] bool sees(const Eigen::Vector3f& point_m) const;
};

/// How many messages a cell's distances have not changed for.
struct CellQuiet {
  std::uint8_t near = kQuiet, far = kQuiet;
  static constexpr std::uint8_t kQuiet = 3;  // it is taken for still
};

struct SeenSurface {
  std::vector<SurfacePoint> points;
  std::vector<CellQuiet> quiet = {};  // of each cell
  SensorSight sight = {};             // by default it sees nothing
};

/// The centres of all cells in which something is seen, at the nearest and at the farthest
/// distance. `depth` has passed wire::decode_control. Lens distortion is ignored: it is smaller
/// than a cell. `before`, of this sensor's last message, or null: what has changed since then, or
/// in the messages before it, moves.
[[nodiscard]] SeenSurface seen_surface(const wire::pb::CoarseDepth& depth,
                                       const wire::pb::Intrinsics& lens,
                                       const RigidTransform& world_from_depth,
                                       const SeenSurface* before = nullptr);

/// Makes `sensor` one of the others of those points of `surface` that `sight` sees, and of no
/// others. Null: it is gone.
void link_other(SensorId sensor, const SensorSight* sight, SeenSurface& surface);

}  // namespace roomcast::hub
