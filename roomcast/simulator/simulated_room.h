// SPDX-License-Identifier: Apache-2.0
// A room ready to be looked at by any number of simulated sensors and free viewpoints: its things,
// the rays through it, and the cloth of whoever moves in it. Immutable and shared.
#pragma once

#include <memory>
#include <string_view>

#include "roomcast/core/result.h"
#include "roomcast/simulator/people/surface_texels.h"
#include "roomcast/simulator/scene/room.h"
#include "roomcast/simulator/tracing/ray_scene.h"

namespace roomcast::simulator {

/// Who is in a room instead of its own people.
enum class Visitor { kNone, kWalkabout, kBoardBearer };

class SimulatedRoom {
 public:
  /// kNotFound for an unknown scene (the message lists them); kUnavailable when the ray tracer does
  /// not start; kInvalidArgument for a visitor where nobody walks about whose ways they could go.
  static Result<std::shared_ptr<const SimulatedRoom>> build(std::string_view scene,
                                                            std::uint64_t seed,
                                                            Visitor visitor = Visitor::kNone);

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
