// SPDX-License-Identifier: Apache-2.0
// LookedPictures: what viewers with the same head saw, against the true view: one with all frames,
// one with those that the hub left him, and, at the same place of a later walk, one alone. Drawn
// after the measurement, so that drawing does not disturb it. Needs OpenGL.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::bench {

struct LookedMoment {
  std::shared_ptr<const client::RoomSnapshot> whole, culled;
  RigidTransform world_from_head;
  nanoseconds scene_time{};  // of their newest picture
  std::shared_ptr<const client::RoomSnapshot> alone = nullptr;
  nanoseconds alone_scene_time{};
};

struct LookedQuality {
  double whole_db = 0, culled_db = 0, alone_db = 0;  // PSNR to the truth, pooled over all moments
  int moments = 0;
};

/// Compares the pixels where somebody who gets all frames sees a surface, of moments with all three
/// pictures. The first moments only
/// build the background. Errors: those of the simulator and of OpenGL.
[[nodiscard]] Result<LookedQuality> compare_pictures(
    const std::vector<LookedMoment>& moments, const std::string& scene,
    const std::function<void(const std::string&)>& progress);

/// Of these pictures: square, with this angle of view.
inline constexpr int kLookedSide_px = 480;
inline constexpr double kLookedFov_rad = 1.2;

}  // namespace roomcast::bench
