// SPDX-License-Identifier: Apache-2.0
// The patterns of somebody's clothes, worked out once: a moving person is coloured by looking up
// texels, some ten times cheaper than evaluating the patterns at every pixel. Immutable after
// construction.
#pragma once

#include <array>

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/source/simulator/people/walking_body.h"

namespace roomcast::sim {

class ClothAtlas {
 public:
  explicit ClothAtlas(const Clothes& clothes);

  /// Albedo at a cloth point (metres), bilinear; points beyond the cloth continue on the other
  /// side.
  [[nodiscard]] Eigen::Vector3f at(Garment garment, const Eigen::Vector2f& cloth_m) const;

 private:
  std::array<Image<Eigen::Vector3f>, kGarmentCount> texels_;
};

}  // namespace roomcast::sim
