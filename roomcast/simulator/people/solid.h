// SPDX-License-Identifier: Apache-2.0
// Solid: smooth shapes as signed distance functions, from which bodies and clothes are modelled:
// hulls of two balls, optionally flattened, blended together, and cut by planes. Metres. Distance
// of a round cone and polynomial smooth minimum: Quilez, "Distance functions".
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace roomcast::simulator {

class Solid {
 public:
  /// Convex hull of two balls; `from` and `to` are their centres.
  struct Bar {
    Eigen::Vector3f from_m, to_m;
    float from_radius_m, to_radius_m;
    /// Scales the cross-section along x and z of the frame in which the bar is given.
    Eigen::Vector2f flat = {1.0F, 1.0F};
    float blend_m = 0.02F;  // width of the blend with existing parts
  };
  void add(const Eigen::Isometry3f& frame, const Bar& bar);
  /// Removes the parts within `reach_m` of `point` on the side that `normal` points to.
  void cut(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, float reach_m);

  /// Approximate signed distance; negative inside, with exact sign.
  [[nodiscard]] float distance(const Eigen::Vector3f& at) const;
  [[nodiscard]] Eigen::Vector3f outward(const Eigen::Vector3f& at) const;  // unit length
  [[nodiscard]] Eigen::AlignedBox3f box() const { return box_; }

 private:
  struct Part {
    Eigen::Affine3f local_from_world;
    float from_radius, to_radius, length, sine, cosine, blend, smallest_scale;
  };
  struct Cut {
    Eigen::Vector3f point, normal;
    float reach;
  };
  [[nodiscard]] static float distance_to(const Part& part, const Eigen::Vector3f& at);

  std::vector<Part> parts_;
  std::vector<Cut> cuts_;
  Eigen::AlignedBox3f box_;
};

}  // namespace roomcast::simulator
