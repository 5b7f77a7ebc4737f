// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/surface_texels.h"

#include <cmath>

namespace roomcast::simulator {
namespace {

using Eigen::Array4f;
using Eigen::Vector2f;

/// Texel resolution: fine for detailed patterns, coarse for plain ones.
struct Grain {
  int side;       // texels; a power of two, so that wrapping is a mask
  float texel_m;  // about the footprint of a colour pixel at two metres
};

Grain grain_of(Pattern pattern) {
  switch (pattern) {
    case Pattern::kFace:
    case Pattern::kTag:
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
    sheet.texels.resize(grain.side, grain.side, Array4f::Zero());
    for (int y = 0; y < grain.side; ++y) {
      for (int x = 0; x < grain.side; ++x) {
        const Vector2f texel(static_cast<float>(x - grain.side / 2),
                             static_cast<float>(y - grain.side / 2));
        sheet.texels.at(x, y).head<3>() =
            albedo_at(surface, grain.texel_m * texel, grain.texel_m).array();
      }
    }
  }
}

Array4f SurfaceTexels::at(SurfaceIndex surface, const Vector2f& uv_m) const {
  const Sheet& sheet = sheets_[surface];
  const int mask = sheet.texels.width() - 1;
  const Vector2f texel = uv_m * sheet.per_m;
  constexpr int kFar = 1 << 14;  // texels, a multiple of every sheet's width: rounds down
  const Vector2f counted = texel.array() + static_cast<float>(kFar + sheet.texels.width() / 2);
  const int x = static_cast<int>(counted.x());
  const int y = static_cast<int>(counted.y());
  const auto value = [&](int i, int j) -> const Array4f& {
    return sheet.texels.at(i & mask, j & mask);
  };
  const float across = counted.x() - static_cast<float>(x);
  const float down = counted.y() - static_cast<float>(y);
  return (1.0F - down) * ((1.0F - across) * value(x, y) + across * value(x + 1, y)) +
         down * ((1.0F - across) * value(x, y + 1) + across * value(x + 1, y + 1));
}

}  // namespace roomcast::simulator
