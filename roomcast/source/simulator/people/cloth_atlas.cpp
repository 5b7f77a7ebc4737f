// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/people/cloth_atlas.h"

#include <cmath>

namespace roomcast::sim {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr int kSide = 256;          // texels; a power of two, so that wrapping is a mask
constexpr float kTexel_m = 0.004F;  // what a colour pixel sees from two metres

Vector2f cloth_of_texel(int x, int y) {
  return kTexel_m * Vector2f(static_cast<float>(x - kSide / 2), static_cast<float>(y - kSide / 2));
}

}  // namespace

ClothAtlas::ClothAtlas(const Clothes& clothes) {
  for (std::size_t garment = 0; garment < texels_.size(); ++garment) {
    const Surface& cloth = worn(clothes, static_cast<Garment>(garment));
    Image<Vector3f>& texels = texels_[garment];
    texels.resize(kSide, kSide, Vector3f::Zero());
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x)
        texels.at(x, y) = albedo_at(cloth, cloth_of_texel(x, y), kTexel_m);
    }
  }
}

Vector3f ClothAtlas::at(Garment garment, const Vector2f& cloth_m) const {
  const Image<Vector3f>& texels = texels_[static_cast<std::size_t>(garment)];
  const Vector2f texel = cloth_m / kTexel_m;
  const float left = std::floor(texel.x());
  const float top = std::floor(texel.y());
  const int x = static_cast<int>(left) + kSide / 2;
  const int y = static_cast<int>(top) + kSide / 2;
  const auto value = [&](int i, int j) -> const Vector3f& {
    return texels.at(i & (kSide - 1), j & (kSide - 1));
  };
  const float across = texel.x() - left;
  const float down = texel.y() - top;
  return (1.0F - down) * ((1.0F - across) * value(x, y) + across * value(x + 1, y)) +
         down * ((1.0F - across) * value(x, y + 1) + across * value(x + 1, y + 1));
}

}  // namespace roomcast::sim
