// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/color_validity.h"

#include <cstdlib>

namespace roomcast::codec {
namespace {

// Largest distance of readings of one surface: 10 mm plus a share.
constexpr int kReach_mm = 10;
constexpr int kReachShare = 32;  // 1/32 of the distance

bool is_near(int measured_mm, int shown_mm) {
  return kReachShare * (std::abs(measured_mm - shown_mm) - kReach_mm) <= shown_mm;
}

}  // namespace

void ColorValidity::update(DepthView measured_mm, DepthView shown_mm, MaskView seen) {
  if (!same_size(seen_.view(), seen)) {
    depth_mm_.resize(seen.width, seen.height);
    seen_.resize(seen.width, seen.height);
    colored_.resize(seen.width, seen.height);
  }
  for (int y = 0; y < seen.height; ++y) {
    const std::uint16_t *measured = measured_mm.row(y), *shown = shown_mm.row(y);
    const std::uint8_t* from = seen.row(y);
    std::uint16_t* depth = depth_mm_.view().row(y);
    std::uint8_t *to = seen_.view().row(y), *colored = colored_.view().row(y);
    for (int x = 0; x < seen.width; ++x) {
      const bool usable = measured[x] != 0 && shown[x] != 0 && is_near(measured[x], shown[x]);
      depth[x] = usable ? measured[x] : std::uint16_t{0};
      to[x] = usable ? from[x] : std::uint8_t{0};
      const bool is_hole = measured[x] == 0 && shown[x] == 0;
      colored[x] = is_hole ? from[x] : to[x];
    }
  }
}

}  // namespace roomcast::codec
