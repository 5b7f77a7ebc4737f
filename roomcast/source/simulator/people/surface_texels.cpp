// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/people/surface_texels.h"

#include <cmath>

namespace roomcast::sim {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

/// Fine where the pattern is small, few where it is plain.
struct Grain {
  int side;       // texels; a power of two, so that wrapping is a mask
  float texel_m;  // about what a colour pixel sees from two metres
};

Grain grain_of(Pattern pattern) {
  switch (pattern) {
    case Pattern::kFace:
      return {256, 0.0025F};
    case Pattern::kPlain:
      return {64, 0.008F};
    default:
      return {256, 0.004F};
  }
}

}  // namespace

SurfaceTexels::SurfaceTexels(const Room& room, const MovingThings& things)
    : sheets_(room.surfaces.size()) {
  std::vector<bool> worn(room.surfaces.size(), false);
  for (const SurfaceIndex surface : things.mesh().surface) worn[surface] = true;
  for (std::size_t i = 0; i < sheets_.size(); ++i) {
    if (!worn[i]) continue;
    const Surface& surface = room.surfaces[i];
    const Grain grain = grain_of(surface.pattern);
    Sheet& sheet = sheets_[i];
    sheet.per_m = 1.0F / grain.texel_m;
    sheet.texels.resize(grain.side, grain.side, Vector3f::Zero());
    for (int y = 0; y < grain.side; ++y) {
      for (int x = 0; x < grain.side; ++x) {
        const Vector2f texel(static_cast<float>(x - grain.side / 2),
                             static_cast<float>(y - grain.side / 2));
        sheet.texels.at(x, y) = albedo_at(surface, grain.texel_m * texel, grain.texel_m);
      }
    }
  }
}

Vector3f SurfaceTexels::at(SurfaceIndex surface, const Vector2f& uv_m) const {
  const Sheet& sheet = sheets_[surface];
  const int mask = sheet.texels.width() - 1;
  const Vector2f texel = uv_m * sheet.per_m;
  const float left = std::floor(texel.x());
  const float top = std::floor(texel.y());
  const int half = sheet.texels.width() / 2;
  const int x = static_cast<int>(left) + half;
  const int y = static_cast<int>(top) + half;
  const auto value = [&](int i, int j) -> const Vector3f& {
    return sheet.texels.at(i & mask, j & mask);
  };
  const float across = texel.x() - left;
  const float down = texel.y() - top;
  return (1.0F - down) * ((1.0F - across) * value(x, y) + across * value(x + 1, y)) +
         down * ((1.0F - across) * value(x, y + 1) + across * value(x + 1, y + 1));
}

}  // namespace roomcast::sim
