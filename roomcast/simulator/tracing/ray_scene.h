// SPDX-License-Identifier: Apache-2.0
// RayScene: intersects rays with a triangle mesh, using Embree 3. Metres. After building, const
// calls are thread-safe.
#pragma once

#include <memory>
#include <optional>

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/simulator/scene/triangle_mesh.h"

namespace roomcast::simulator {

struct RayHit {
  float t = 0;  // in multiples of the given direction's length
  std::uint32_t triangle = 0;
  Eigen::Vector3f normal;  // interpolated, unit length, turned towards the ray's origin
  Eigen::Vector2f uv_m;
};

class RayScene {
 public:
  /// Keeps a reference to the mesh, which must outlive it. kUnavailable if Embree does not work on
  /// this machine.
  static Result<std::unique_ptr<RayScene>> build(const TriangleMesh& mesh);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  [[nodiscard]] std::optional<RayHit> first_hit(const Eigen::Vector3f& origin_m,
                                                const Eigen::Vector3f& direction) const;
  /// True if a surface is between the two points (a millimetre at both ends is ignored).
  [[nodiscard]] bool blocked(const Eigen::Vector3f& from_m, const Eigen::Vector3f& to_m) const;

 private:
  struct Handles;
  RayScene(const TriangleMesh& mesh, std::unique_ptr<Handles> handles);

  const TriangleMesh& mesh_;
  std::unique_ptr<Handles> handles_;
};

}  // namespace roomcast::simulator
