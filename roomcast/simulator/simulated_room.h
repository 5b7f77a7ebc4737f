// SPDX-License-Identifier: Apache-2.0
// SimulatedRoom: a room prepared for rendering by any number of simulated sensors and free
// viewpoints: its objects, the ray tracer's scene, and the texels of its moving surfaces. Immutable
// and shared.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "roomcast/core/result.h"
#include "roomcast/simulator/people/surface_texels.h"
#include "roomcast/simulator/scene/room.h"
#include "roomcast/simulator/tracing/ray_scene.h"

namespace roomcast::simulator {

/// A person who replaces the room's own people.
enum class Visitor { kNone, kWalkabout, kBoardBearer };

class SimulatedRoom {
 public:
  /// `cabinet`: the place of a cabinet (scene/moved_cabinet.h). kNotFound for an unknown scene (the
  /// message lists them); kUnavailable if the ray tracer does not start; kInvalidArgument for a
  /// visitor in a scene without a walking person, whose paths the visitor would use, and for a
  /// cabinet in one without space.
  static Result<std::shared_ptr<const SimulatedRoom>> build(std::string_view scene,
                                                            std::uint64_t seed,
                                                            Visitor visitor = Visitor::kNone,
                                                            std::optional<int> cabinet = {});

  [[nodiscard]] const simulator::Room& room() const { return room_; }
  [[nodiscard]] const simulator::RayScene& rays() const { return *rays_; }
  [[nodiscard]] const simulator::SurfaceTexels& texels() const { return *texels_; }

 private:
  explicit SimulatedRoom(simulator::Room room) : room_(std::move(room)) {}

  simulator::Room room_;
  std::unique_ptr<const simulator::RayScene> rays_;
  std::unique_ptr<const simulator::SurfaceTexels> texels_;
};

}  // namespace roomcast::simulator
