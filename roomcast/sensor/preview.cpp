// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/preview.h"

#include <algorithm>
#include <cmath>

#include "roomcast/io/image_file.h"

namespace roomcast::sensor {
namespace {

constexpr int kQuality = 80;
constexpr double kNear_mm = 500, kFar_mm = 5000;

std::uint8_t level(double share) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

}  // namespace

Rgb8 color_of_depth(std::uint16_t depth_mm) {
  if (depth_mm == 0) return {};
  // Even steps of 1 / depth give near and far ranges the same share of the colours.
  const double near = 1 / kNear_mm, far = 1 / kFar_mm;
  const double share = std::clamp((near - 1.0 / depth_mm) / (near - far), 0.0, 1.0);
  const double hue = 4 * share;  // 0 red, 1 yellow, 2 green, 3 cyan, 4 blue
  return {level(2 - hue), level(hue < 2 ? hue : 4 - hue), level(hue - 2)};
}

Status Preview::show(DepthView depth_mm, ColorView color, HostTime now) {
  if (written_ != HostTime{} && now - written_ < kPeriod) return {};
  written_ = now;
  picture_.resize(2 * depth_mm.width, depth_mm.height);
  const int step = color.width / depth_mm.width;  // colour may have twice the resolution
  for (int y = 0; y < depth_mm.height; ++y) {
    Rgb8* const row = picture_.view().row(y);
    for (int x = 0; step > 0 && x < depth_mm.width; ++x) row[x] = color.at(step * x, step * y);
    std::transform(depth_mm.row(y), depth_mm.row(y) + depth_mm.width, row + depth_mm.width,
                   color_of_depth);
  }
  return io::write_color_jpeg(file_, picture_, kQuality);
}

}  // namespace roomcast::sensor
