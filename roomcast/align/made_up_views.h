// SPDX-License-Identifier: Apache-2.0
// For tests: views of the made-up room from its corners, made once.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "roomcast/align/made_up_room.h"
#include "roomcast/align/sensor_view.h"

namespace roomcast::align {

struct MadeUpView {
  RigidTransform world_from_depth;
  std::shared_ptr<const SensorView> view;
};

inline MadeUpView made_up_view(const MadeUpRoom& room, const std::string& name,
                               const RigidTransform& world_from_depth) {
  auto view = make_sensor_view(made_up_bundle(room, name, world_from_depth));
  ROOMCAST_ASSERT(view.ok());
  return {world_from_depth, std::make_shared<const SensorView>(std::move(*view))};
}

/// Two corners of the same long wall, about 90 degrees apart, and one across from the first.
inline const MadeUpView& first_corner() {
  static const MadeUpView view = made_up_view({}, "s0", corner_pose(2, 1.5));
  return view;
}
inline const MadeUpView& second_corner() {
  static const MadeUpView view = made_up_view({}, "s1", corner_pose(-2, 1.5));
  return view;
}
inline const MadeUpView& third_corner() {
  static const MadeUpView view = made_up_view({}, "s2", corner_pose(-2, -1.5));
  return view;
}

inline RigidTransform true_pose(const MadeUpView& a, const MadeUpView& b) {
  return a.world_from_depth.inverse() * b.world_from_depth;
}

}  // namespace roomcast::align
