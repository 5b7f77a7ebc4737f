// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/surface_coder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace roomcast::codec {
namespace {

constexpr float kMinGap = 10 * kLevelsPerSigma;
constexpr float kLowRounding = 0.45f, kHighRounding = 0.10f;
constexpr float kWorthCoding = 3.5f;  // in standard deviations of the noise of a coefficient

/// Least-squares plane; its value at pixel (x, y) is mean + slope_x x + slope_y y.
struct Plane {
  float mean = 0, slope_x = 0, slope_y = 0;
};

/// 1 for pixels on a surface, else 0.
using Membership = std::array<float, kBlockPixels>;

Membership members(const BlockCode& code, const BlockTarget& target, PixelLabel label) {
  Membership on_it;
  for (std::size_t k = 0; k < kBlockPixels; ++k) {
    // Branch-free, so that the compiler vectorises it.
    const int on = int{code.labels[k] == label} & int{target[k] > 0};
    on_it[k] = static_cast<float>(on);
  }
  return on_it;
}

/// Sums over the pixels of a surface, with z relative to `origin`.
struct Moments {
  float n = 0, x = 0, y = 0, z = 0, xx = 0, yy = 0, xy = 0, xz = 0, yz = 0;
};

// Column by column, so that the compiler vectorises it.
Moments moments_of(const Membership& on_it, const BlockTarget& target, float origin) {
  float n[8] = {}, z[8] = {}, y[8] = {}, yy[8] = {}, yz[8] = {};
  for (int row = 0; row < 8; ++row) {
    const auto at = static_cast<float>(row);
    for (int column = 0; column < 8; ++column) {
      const auto k = static_cast<std::size_t>(8 * row + column);
      const float w = on_it[k], wz = w * (target[k] - origin);
      n[column] += w;
      z[column] += wz;
      y[column] += at * w;
      yy[column] += at * at * w;
      yz[column] += at * wz;
    }
  }
  Moments sums;
  for (int column = 0; column < 8; ++column) {
    const auto at = static_cast<float>(column);
    sums.n += n[column];
    sums.z += z[column];
    sums.y += y[column];
    sums.yy += yy[column];
    sums.yz += yz[column];
    sums.x += at * n[column];
    sums.xx += at * at * n[column];
    sums.xy += at * y[column];
    sums.xz += at * z[column];
  }
  return sums;
}

Plane fitted_plane(const Membership& on_it, const BlockTarget& target) {
  const auto first = std::find(on_it.begin(), on_it.end(), 1.0f);
  const float origin =
      first == on_it.end() ? 0 : target[static_cast<std::size_t>(first - on_it.begin())];
  const Moments s = moments_of(on_it, target, origin);
  const float mx = s.x / s.n, my = s.y / s.n, mz = s.z / s.n;
  Plane plane{mz + origin, 0, 0};
  if (s.n < 8) return plane;
  constexpr float kRidge = 4;  // limits the slope across a thin strip
  const float xx = s.xx - s.x * mx + kRidge, yy = s.yy - s.y * my + kRidge, xy = s.xy - s.x * my;
  const float xz = s.xz - s.x * mz, yz = s.yz - s.y * mz, det = xx * yy - xy * xy;
  if (det <= 16) return plane;
  plane.slope_x = (xz * yy - yz * xy) / det;
  plane.slope_y = (yz * xx - xz * xy) / det;
  plane.mean = mz + origin - plane.slope_x * mx - plane.slope_y * my;
  return plane;
}

/// The target on the surface's pixels, the plane elsewhere.
void fill(const Membership& on_it, const BlockTarget& target, const Plane& plane,
          std::array<float, kBlockPixels>& filled) {
  for (std::size_t row = 0; row < kBlockSide; ++row) {
    const float at_row = plane.mean + plane.slope_y * static_cast<float>(row);
    for (std::size_t column = 0; column < kBlockSide; ++column) {
      const std::size_t k = kBlockSide * row + column;
      const float flat = at_row + plane.slope_x * static_cast<float>(column);
      filled[k] = flat + on_it[k] * (target[k] - flat);
    }
  }
}

/// Increases with the bits of the three lowest coefficients: roughly 2 to the power of their
/// number.
float prediction_cost(const std::array<float, kBlockPixels>& wanted, const SurfaceParameters& by,
                      float step) {
  const auto steps = [step](float off) { return 1 + std::abs(off) / step; };
  return steps(wanted[0] - static_cast<float>(by.mean)) *
         steps(wanted[1] - static_cast<float>(by.slope_x)) *
         steps(wanted[8] - static_cast<float>(by.slope_y));
}

std::uint8_t cheapest(const SurfaceCandidates& candidates,
                      const std::array<float, kBlockPixels>& wanted, int step) {
  std::uint8_t best = 0;
  float least = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < kSurfaceCandidates; ++i) {
    if (!candidates[i].known) continue;
    const float cost = prediction_cost(wanted, candidates[i], static_cast<float>(step));
    if (cost < least) {
      least = cost;
      best = static_cast<std::uint8_t>(i);
    }
  }
  return best;
}

/// Standard deviation of the noise in the block's coefficients, estimated from the high ones.
float noise_of(const std::array<float, kBlockPixels>& wanted, float share_seen) {
  constexpr std::size_t kFirstHigh = 28, kCount = kBlockPixels - kFirstHigh;
  std::array<float, kCount> sizes;
  for (std::size_t i = 0; i < kCount; ++i) sizes[i] = std::abs(wanted[kZigzag[kFirstHigh + i]]);
  float sum = 0, limited_sum = 0;
  for (const float size : sizes) sum += size;
  // Coefficients above noise count as twice the mean.
  for (const float size : sizes) limited_sum += std::min(size, 2 * sum / kCount);
  constexpr float kLimitedMeanOfGaussian = 0.75f;
  return limited_sum / (kCount * kLimitedMeanOfGaussian * std::sqrt(share_seen));
}

void quantise(std::array<float, kBlockPixels> wanted, const SurfaceParameters& prediction, int step,
              float least, BlockCoefficients& steps) {
  if (prediction.known) {
    wanted[0] -= static_cast<float>(prediction.mean);
    wanted[1] -= static_cast<float>(prediction.slope_x);
    wanted[8] -= static_cast<float>(prediction.slope_y);
  }
  const auto width = static_cast<float>(step);
  for (std::size_t k = 0; k < kBlockPixels; ++k) {
    steps[k] = std::abs(wanted[k]) < least ? 0 : quantised(wanted[k], width, kHighRounding);
  }
  for (const std::size_t k : {0, 1, 8}) steps[k] = quantised(wanted[k], width, kLowRounding);
  steps[kBlockPixels - 1] = 0;  // the highest frequency is never coded
}

float largest_error(const Membership& on_it, const BlockTarget& target, const BlockValues& values) {
  std::array<float, kBlockSide> largest{};
  for (std::size_t k = 0; k < kBlockPixels; ++k) {
    const float off = on_it[k] * std::abs(static_cast<float>(values[k]) - target[k]);
    largest[k % kBlockSide] = std::max(largest[k % kBlockSide], off);
  }
  return *std::max_element(largest.begin(), largest.end());
}

/// Gap between two values adjacent in size.
struct Gap {
  float size = 0, middle = 0;
};

/// Range of the values on a surface. Column by column, so that the compiler vectorises it.
struct Range {
  float least = 1e9f, most = -1e9f;
};
Range range_of(const Membership& on_it, const BlockTarget& target) {
  std::array<Range, kBlockSide> columns{};
  for (std::size_t k = 0; k < kBlockPixels; ++k) {
    Range& column = columns[k % kBlockSide];
    column.least = std::min(column.least, on_it[k] != 0 ? target[k] : 1e9f);
    column.most = std::max(column.most, on_it[k] != 0 ? target[k] : -1e9f);
  }
  Range range;
  for (const Range& column : columns) {
    range.least = std::min(range.least, column.least);
    range.most = std::max(range.most, column.most);
  }
  return range;
}

/// In linear time (Gonzalez 1975): the largest gap of n values does not fit into one of n equal
/// parts of their range, so only the least and the largest value of each part matter.
Gap largest_gap(const Membership& on_it, const BlockTarget& target, const Range& range) {
  std::array<Range, kBlockPixels> parts{};
  const float scale = (kBlockPixels - 0.01f) / (range.most - range.least);
  for (std::size_t k = 0; k < kBlockPixels; ++k) {
    if (on_it[k] == 0) continue;
    Range& part = parts[static_cast<std::size_t>((target[k] - range.least) * scale)];
    part.least = std::min(part.least, target[k]);
    part.most = std::max(part.most, target[k]);
  }
  Gap largest;
  float before = range.least;  // largest value of the parts so far
  for (const Range& part : parts) {
    if (part.most < part.least) continue;
    if (part.least - before > largest.size) {
      largest = {part.least - before, (part.least + before) / 2};
    }
    before = part.most;
  }
  return largest;
}

}  // namespace

void split_surfaces(BlockCode& code, BlockTarget& target) {
  const Membership on_it = members(code, target, PixelLabel::kFirst);
  const Range range = range_of(on_it, target);
  code.surface_count = 0;
  if (range.most < range.least) {
    std::replace(code.labels.begin(), code.labels.end(), PixelLabel::kFirst,
                 PixelLabel::kUnchanged);
    return;
  }
  code.surface_count = 1;
  if (range.most - range.least <= kMinGap) return;  // most blocks
  const Gap gap = largest_gap(on_it, target, range);
  if (gap.size <= kMinGap) return;
  code.surface_count = 2;
  for (std::size_t k = 0; k < kBlockPixels; ++k) {
    if (code.labels[k] == PixelLabel::kFirst && target[k] > gap.middle) {
      code.labels[k] = PixelLabel::kSecond;
    }
  }
}

bool encode_surface(const SurfaceCandidates& candidates, PixelLabel label, int step,
                    const BlockCode& code, const BlockTarget& target, SurfaceCode& surface) {
  const Membership on_it = members(code, target, label);
  const Plane plane = fitted_plane(on_it, target);
  std::array<float, kBlockPixels> filled, wanted;
  fill(on_it, target, plane, filled);
  forward_transform(filled, wanted);
  surface.candidate = cheapest(candidates, wanted, step);
  const SurfaceParameters& prediction = candidates[surface.candidate];
  const float seen = std::accumulate(on_it.begin(), on_it.end(), 0.0f);
  const float noise = std::clamp(noise_of(wanted, seen / kBlockPixels), 0.5f * kLevelsPerSigma,
                                 1.2f * kLevelsPerSigma);
  for (surface.finer = 0;; ++surface.finer) {
    quantise(wanted, prediction, step >> surface.finer,
             kWorthCoding * noise / static_cast<float>(1 << surface.finer), surface.steps);
    BlockCoefficients coefficients;
    BlockValues values;
    const int rows =
        surface_coefficients(surface.steps, step >> surface.finer, prediction, coefficients);
    inverse_transform(coefficients, rows, values);
    const bool bounded = largest_error(on_it, target, values) <= static_cast<float>(kErrorBound);
    if (bounded || surface.finer == kMaxFiner) return bounded;
  }
}

}  // namespace roomcast::codec
