// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/surface_coder.h"

#include <algorithm>
#include <cmath>

namespace roomcast::codec {
namespace {

constexpr float kLeastGap = 10 * kLevelsPerSigma;
constexpr float kLowRounding = 0.45f, kHighRounding = 0.10f;
constexpr float kWorthCoding = 3;  // standard deviations of noise in a coefficient
constexpr float kVisibleError = 4.5f * kLevelsPerSigma;
constexpr int kMostVisible = 2;  // pixels of a block that may be off by more

/// The plane that fits best, at pixel (x, y): mean + slope_x x + slope_y y.
struct Plane {
  float mean = 0, slope_x = 0, slope_y = 0;
  [[nodiscard]] float at(int k) const {
    return mean + slope_x * static_cast<float>(k % 8) + slope_y * static_cast<float>(k / 8);
  }
};

bool on(const BlockCode& code, const BlockTarget& target, PixelLabel label, std::size_t k) {
  return code.labels[k] == label && target[k] > 0;
}

Plane fitted_plane(const BlockCode& code, const BlockTarget& target, PixelLabel label) {
  float n = 0, sx = 0, sy = 0, sz = 0, sxx = 0, syy = 0, sxy = 0, sxz = 0, syz = 0;
  float origin = 0;
  for (int k = 0; k < kBlockPixels; ++k) {
    if (!on(code, target, label, static_cast<std::size_t>(k))) continue;
    const auto x = static_cast<float>(k % 8), y = static_cast<float>(k / 8);
    if (n == 0) origin = target[static_cast<std::size_t>(k)];
    const float z = target[static_cast<std::size_t>(k)] - origin;
    n += 1;
    sx += x;
    sy += y;
    sz += z;
    sxx += x * x;
    syy += y * y;
    sxy += x * y;
    sxz += x * z;
    syz += y * z;
  }
  const float mx = sx / n, my = sy / n, mz = sz / n;
  Plane plane{mz + origin, 0, 0};
  if (n < 8) return plane;
  constexpr float kRidge = 4;  // keeps a thin strip from tipping over
  const float xx = sxx - sx * mx + kRidge, yy = syy - sy * my + kRidge, xy = sxy - sx * my;
  const float xz = sxz - sx * mz, yz = syz - sy * mz, det = xx * yy - xy * xy;
  if (det <= 16) return plane;
  plane.slope_x = (xz * yy - yz * xy) / det;
  plane.slope_y = (yz * xx - xz * xy) / det;
  plane.mean = mz + origin - plane.slope_x * mx - plane.slope_y * my;
  return plane;
}

std::int32_t rounded(float value, float step, float rounding) {
  const auto size = static_cast<std::int32_t>(std::abs(value) / step + rounding);
  return value < 0 ? -size : size;
}

/// About the bits that the three lowest coefficients would take.
float prediction_cost(const std::array<float, kBlockPixels>& wanted, const SurfaceParameters& by,
                      float step) {
  const auto bits = [step](float off) { return std::log2(1 + std::abs(off) / step); };
  return bits(wanted[0] - static_cast<float>(by.mean)) +
         bits(wanted[1] - static_cast<float>(by.slope_x)) +
         bits(wanted[8] - static_cast<float>(by.slope_y));
}

std::uint8_t cheapest(const SurfaceCandidates& candidates,
                      const std::array<float, kBlockPixels>& wanted, int step) {
  std::uint8_t best = 0;
  float least = 1e9f;
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

/// Standard deviation of the noise in the block's coefficients, from the size
/// of the high ones.
float noise_of(const std::array<float, kBlockPixels>& wanted, float share_seen) {
  constexpr std::size_t kFirstHigh = 28, kCount = kBlockPixels - kFirstHigh;
  std::array<float, kCount> sizes;
  for (std::size_t i = 0; i < kCount; ++i) sizes[i] = std::abs(wanted[kZigzag[kFirstHigh + i]]);
  std::nth_element(sizes.begin(), sizes.begin() + kCount / 2, sizes.end());
  constexpr float kMedianOfGaussian = 0.6745f;
  return sizes[kCount / 2] / (kMedianOfGaussian * std::sqrt(share_seen));
}

void quantise(std::array<float, kBlockPixels> wanted, const SurfaceParameters& prediction, int step,
              float least, BlockCoefficients& steps) {
  if (prediction.known) {
    wanted[0] -= static_cast<float>(prediction.mean);
    wanted[1] -= static_cast<float>(prediction.slope_x);
    wanted[8] -= static_cast<float>(prediction.slope_y);
  }
  for (std::size_t k = 0; k + 1 < kBlockPixels; ++k) {
    const bool low = k <= 1 || k == 8;
    if (low)
      steps[k] = rounded(wanted[k], static_cast<float>(step), kLowRounding);
    else
      steps[k] = std::abs(wanted[k]) < least
                     ? 0
                     : rounded(wanted[k], static_cast<float>(step), kHighRounding);
  }
  steps[kBlockPixels - 1] = 0;  // the highest frequency is never coded
}

struct SurfaceError {
  int visible = 0;
  float largest = 0;
};

SurfaceError error_of(const BlockCode& code, const BlockTarget& target, PixelLabel label,
                      const BlockValues& values) {
  SurfaceError error;
  for (std::size_t k = 0; k < kBlockPixels; ++k) {
    if (!on(code, target, label, k)) continue;
    const float off = std::abs(static_cast<float>(values[k]) - target[k]);
    error.visible += off > kVisibleError;
    error.largest = std::max(error.largest, off);
  }
  return error;
}

}  // namespace

void split_surfaces(BlockCode& code, BlockTarget& target) {
  std::array<float, kBlockPixels> sorted;
  std::size_t n = 0;
  for (std::size_t k = 0; k < kBlockPixels; ++k) {
    if (on(code, target, PixelLabel::kFirst, k)) sorted[n++] = target[k];
  }
  std::sort(sorted.begin(), sorted.begin() + n);
  float gap = 0, middle = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (sorted[i] - sorted[i - 1] <= gap) continue;
    gap = sorted[i] - sorted[i - 1];
    middle = (sorted[i] + sorted[i - 1]) / 2;
  }
  code.surface_count = n == 0 ? 0 : gap > kLeastGap ? 2 : 1;
  for (std::size_t k = 0; k < kBlockPixels; ++k) {
    if (code.labels[k] != PixelLabel::kFirst) continue;
    if (n == 0)
      code.labels[k] = PixelLabel::kStay;
    else if (code.surface_count == 2 && target[k] > middle)
      code.labels[k] = PixelLabel::kSecond;
  }
}

bool encode_surface(const SurfaceCandidates& candidates, PixelLabel label, int step,
                    const BlockCode& code, const BlockTarget& target, SurfaceCode& surface) {
  const Plane plane = fitted_plane(code, target, label);
  std::array<float, kBlockPixels> filled, wanted;
  for (int k = 0; k < kBlockPixels; ++k) {
    const auto i = static_cast<std::size_t>(k);
    filled[i] = on(code, target, label, i) ? target[i] : plane.at(k);
  }
  forward_transform(filled, wanted);
  surface.candidate = cheapest(candidates, wanted, step);
  const SurfaceParameters& prediction = candidates[surface.candidate];
  float seen = 0;
  for (std::size_t k = 0; k < kBlockPixels; ++k) seen += on(code, target, label, k);
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
    const SurfaceError error = error_of(code, target, label, values);
    const bool bounded = error.largest <= kErrorBound;
    if ((bounded && error.visible <= kMostVisible) || surface.finer == kMostFiner) return bounded;
  }
}

}  // namespace roomcast::codec
