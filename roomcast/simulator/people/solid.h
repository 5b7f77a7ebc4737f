// SPDX-License-Identifier: Apache-2.0
// Soft shapes by their distance: hulls of two balls, possibly flattened, melted into one another,
// and cut off by planes. What bodies and their clothes are modelled from. Metres.
// Distance of a round cone and polynomial smooth minimum: Quilez, "Distance functions".
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace roomcast::simulator {

class Solid {
 public:
  /// Two balls and their hull; the second argument pair is where they are.
  struct Bar {
    Eigen::Vector3f from_m, to_m;
    float from_radius_m, to_radius_m;
    /// Stretches the cross-section along x and z of the frame it is given in.
    Eigen::Vector2f flat = {1.0F, 1.0F};
    float melt_m = 0.02F;  // over how far it flows into what is there already
  };
  void add(const Eigen::Isometry3f& frame, const Bar& bar);
  /// Takes away what is within `reach_m` of `point` and on the side of it that `normal` points to.
  void cut(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, float reach_m);

  /// About the distance; negative inside, exact in sign.
  [[nodiscard]] float distance(const Eigen::Vector3f& at) const;
  [[nodiscard]] Eigen::Vector3f outward(const Eigen::Vector3f& at) const;  // unit length
  [[nodiscard]] Eigen::AlignedBox3f box() const { return box_; }

 private:
  struct Part {
    Eigen::Affine3f local_from_world;
    float from_radius, to_radius, length, sine, cosine, melt, smallest_scale;
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
