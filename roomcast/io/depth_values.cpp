// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/depth_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomcast::io {
namespace {

constexpr std::size_t kDepthValues = std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1;
constexpr double kMillimetresPerMetre = 1000;

bool already_mm(const RecordedCamera& camera) {
  const auto zero = [](std::uint16_t value) { return value == 0; };
  return camera.depth_scale_to_metre * kMillimetresPerMetre == 1.0 && camera.depth_bias_m == 0 &&
         std::all_of(camera.invalid_depth.begin(), camera.invalid_depth.end(), zero);
}

}  // namespace

DepthValues::DepthValues(const RecordedCamera& camera) {
  if (already_mm(camera)) return;
  mm_from_value_.resize(kDepthValues);
  for (std::size_t value = 1; value < kDepthValues; ++value) {
    const double mm = std::round(
        kMillimetresPerMetre *
        (static_cast<double>(value) * camera.depth_scale_to_metre + camera.depth_bias_m));
    const bool fits = mm > 0 && mm <= std::numeric_limits<std::uint16_t>::max();
    mm_from_value_[value] = fits ? static_cast<std::uint16_t>(mm) : std::uint16_t{0};
  }
  for (const std::uint16_t invalid : camera.invalid_depth) mm_from_value_[invalid] = 0;
}

void DepthValues::to_mm(DepthImage& depth) const {
  if (mm_from_value_.empty()) return;
  std::uint16_t* const values = depth.data();
  for (std::size_t i = 0; i < depth.view().pixel_count(); ++i)
    values[i] = mm_from_value_[values[i]];
}

}  // namespace roomcast::io
