// SPDX-License-Identifier: Apache-2.0
// MovingThings: all moving things in a room at one instant (people and the objects they carry) as
// triangles in the world frame. Triangles, surfaces and texture coordinates never change; positions
// and normals are a function of the scene time alone. So the picture of an instant does not depend
// on earlier calls, and a full trace of the room at that instant is a trace of the room's mesh and
// this one together. Single-threaded; `move_to` does not allocate.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

/// A body part or an object: a run of triangles and of vertices, and its bounding box.
struct MovingPart {
  std::uint32_t first_vertex = 0, vertex_count = 0;
  std::uint32_t first_triangle = 0, triangle_count = 0;
  Eigen::AlignedBox3f box_m;
};

/// A ball that approximates part of a body when shading the floor.
struct ShadeBall {
  Eigen::Vector3f centre_m;
  float radius_m;
};

class MovingThings {
 public:
  /// `speed`: 1: real speed, 0.05: slow motion, 0: nothing moves. Keeps no reference to the room.
  explicit MovingThings(const Room& room, double speed = 1.0);
  ~MovingThings();
  MovingThings(MovingThings&&) noexcept;
  MovingThings& operator=(MovingThings&&) noexcept;

  /// Any scene time, also negative.
  void move_to(nanoseconds scene_time);

  /// Surfaces are indices into Room::surfaces. Closed, front faces counter-clockwise.
  [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
  /// Per vertex: share of the surroundings that the body itself does not hide, 0..1.
  [[nodiscard]] std::span<const float> openness() const { return openness_; }
  [[nodiscard]] std::span<const MovingPart> parts() const { return parts_; }
  [[nodiscard]] std::span<const ShadeBall> shade_balls() const { return shade_balls_; }

 private:
  struct MovingPerson;
  std::vector<MovingPerson> people_;
  double speed_;
  std::optional<nanoseconds> scene_time_;
  TriangleMesh mesh_;
  std::vector<float> openness_;
  std::vector<MovingPart> parts_;
  std::vector<ShadeBall> shade_balls_;
};

}  // namespace roomcast::simulator
