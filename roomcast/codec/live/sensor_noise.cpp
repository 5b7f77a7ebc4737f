// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/sensor_noise.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace roomcast::codec {
namespace {

constexpr std::uint32_t kMinSamples = 100;  // at a distance; with fewer it counts as unknown
constexpr int kHalfLife_frames = 45;        // short, because a sensor warms up or is reconfigured
constexpr double kTrim = 3.5;               // standard deviations
constexpr double kMinSigma_mm = 0.25;
constexpr int kPartsOfKnot = 4;      // in each, distances are compared with the most frequent one
constexpr std::uint32_t kRare = 8;   // times less frequent than that
constexpr double kStepWeight = 0.5;  // of a quantisation step, as noise: a plane is read as stairs

/// Standard deviation of the differences in a histogram of their sizes, without outliers.
template <class Histogram>
double trimmed_deviation(const Histogram& sizes) {
  double limit = static_cast<double>(sizes.size()), deviation = 0;
  for (int round = 0; round < 8; ++round) {
    double squares = 0, count = 0;
    for (std::size_t size = 0; size < sizes.size() && static_cast<double>(size) <= limit; ++size) {
      squares += static_cast<double>(sizes[size]) * static_cast<double>(size * size);
      count += sizes[size];
    }
    if (count == 0) return 0;
    deviation = std::sqrt(squares / count);
    limit = std::max(1.0, kTrim * deviation);
  }
  return deviation;
}

using Sigmas = std::array<double, kSigmaKnotCount>;

double levels_needed(const Sigmas& sigma) {
  double levels = 0;
  for (int knot = 0; knot + 1 < kSigmaKnotCount; ++knot) {
    const double begin = knot == 0 ? 0 : sigma_knot_mm(knot);
    levels += (sigma_knot_mm(knot + 1) - begin) / sigma[static_cast<std::size_t>(knot)];
  }
  return kLevelsPerSigma * levels;
}

/// Raises the smallest sigmas until the levels suffice: with hardly any noise, 16 bits would not.
void fit_into_levels(Sigmas& sigma) {
  constexpr double kMaxLevels = 50000;  // leaves a margin for the rounding of codes
  for (double least = kMinSigma_mm; levels_needed(sigma) > kMaxLevels; least *= 1.1) {
    for (double& value : sigma) value = std::max(value, least);
  }
}

/// Noise of a time-of-flight camera, mm; for distances that were never seen.
double usual_sigma_mm(double depth_mm) {
  const double z = depth_mm / 1000;
  return 1.5 + 0.25 * z * z;
}

}  // namespace

void SensorNoise::observe(DepthView depth_mm) {
  const auto width = static_cast<std::size_t>(depth_mm.width);
  const bool first = width_ != depth_mm.width || height_ != depth_mm.height;
  if (first) {
    *this = {};
    width_ = depth_mm.width;
    height_ = depth_mm.height;
    readings_at_mm_.assign(65536, 0);
    before_.assign(width * static_cast<std::size_t>(height_), 0);
  }
  const int apart = first ? 1 : kRowsApart;  // the first table needs all rows of the first frame
  for (int y = first ? 0 : phase_; y < height_; y += apart) {
    observe_row(depth_mm.row(y), &before_[static_cast<std::size_t>(y) * width], width_);
  }
  if (++frames_ % kHalfLife_frames == 0) forget_half();
  // The next frame reads other rows; keep their current values.
  phase_ = (phase_ + 3) % kRowsApart;
  for (int y = phase_; y < height_; y += kRowsApart) {
    std::copy_n(depth_mm.row(y), width, &before_[static_cast<std::size_t>(y) * width]);
  }
}

void SensorNoise::observe_row(const std::uint16_t* row, const std::uint16_t* before, int width) {
  for (int x = 1; x < width - 1; ++x) {
    const int z = row[x];
    if (z == 0) continue;
    const auto knot = static_cast<std::size_t>(sigma_knot_of(z));
    ++readings_at_mm_[static_cast<std::size_t>(z)];
    if (before[x] != 0) {
      const auto change = static_cast<std::size_t>(std::abs(z - before[x]));
      if (change < kMaxChange_mm) {
        ++in_time_[knot][change];
        ++time_samples_[knot];
      }
    }
    if (row[x - 1] != 0 && row[x + 1] != 0) {
      const auto bend = static_cast<std::size_t>(std::abs(2 * z - row[x - 1] - row[x + 1]));
      if (bend < kMaxChange_mm) {
        ++in_space_[knot][bend];
        ++space_samples_[knot];
      }
    }
  }
}

void SensorNoise::forget_half() {
  for (auto* histograms : {&in_time_, &in_space_}) {
    for (Histogram& histogram : *histograms) {
      for (std::uint32_t& count : histogram) count /= 2;
    }
  }
  for (auto* samples : {&time_samples_, &space_samples_}) {
    for (std::uint32_t& count : *samples) count /= 2;
  }
  for (std::uint32_t& count : readings_at_mm_) count /= 2;
}

/// The lower quartile of the gaps between the distances that occur, mm: larger gaps are the
/// scene's. A distance that is rare beside another near it does not count: a few readings between
/// the sensor's own distances, as of interpolation or of an earlier depth scale, hide no steps.
double SensorNoise::step_at(int knot) const {
  const int begin = knot == 0 ? 1 : sigma_knot_mm(knot);
  const int end = std::min(65536, sigma_knot_mm(knot + 1));
  std::vector<int> gaps;
  const int part_mm = std::max((end - begin) / kPartsOfKnot, 1);
  for (int from = begin, last = 0; from < end; from += part_mm) {
    const int to = std::min(from + part_mm, end);
    const std::uint32_t most = *std::max_element(&readings_at_mm_[static_cast<std::size_t>(from)],
                                                 readings_at_mm_.data() + to);
    for (int z = from; z < to; ++z) {
      if (kRare * readings_at_mm_[static_cast<std::size_t>(z)] <= most) continue;
      if (last > 0) gaps.push_back(z - last);
      last = z;
    }
  }
  if (gaps.size() < 2) return 1;
  const auto quartile = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 4);
  std::nth_element(gaps.begin(), quartile, gaps.end());
  return *quartile;
}

/// 0 with too few samples at this distance.
double SensorNoise::sigma_at(int knot) const {
  const auto k = static_cast<std::size_t>(knot);
  double noise = 0;
  if (time_samples_[k] >= kMinSamples) {
    noise = trimmed_deviation(in_time_[k]) / std::sqrt(2.0);
  } else if (space_samples_[k] >= kMinSamples) {
    noise = trimmed_deviation(in_space_[k]) / std::sqrt(6.0);
  } else {
    return 0;
  }
  const double step = step_at(knot);
  const double stairs = step > 1.5 ? kStepWeight * step : 0;
  return std::max(kMinSigma_mm, std::hypot(noise, stairs));
}

SigmaCodes SensorNoise::table() const {
  Sigmas sigma{};
  // A histogram covers the distances from its knot to the next; its value is valid halfway between.
  double known = 0, known_at = 0;
  for (int knot = 0; knot < kSigmaKnotCount; ++knot) {
    const double here = knot + 1 < kSigmaKnotCount ? sigma_at(knot) : 0;
    const double z = sigma_knot_mm(knot);
    if (here > 0) {
      sigma[static_cast<std::size_t>(knot)] = here;
      known = here;
      known_at = z;
    } else if (known > 0) {
      sigma[static_cast<std::size_t>(knot)] = known * (z / known_at) * (z / known_at);
    }
  }
  for (int knot = kSigmaKnotCount; knot-- > 0;) {  // distances nearer than all readings
    double& here = sigma[static_cast<std::size_t>(knot)];
    if (here > 0) continue;
    here = known > 0 ? sigma[static_cast<std::size_t>(knot) + 1] * sigma_knot_mm(knot) /
                           sigma_knot_mm(knot + 1)
                     : usual_sigma_mm(sigma_knot_mm(knot));
  }
  fit_into_levels(sigma);
  SigmaCodes codes{};
  for (std::size_t knot = 0; knot < kSigmaKnotCount; ++knot) {
    // Geometric mean of the intervals on both sides: the table is linear between knots.
    const double before = sigma[knot == 0 ? 0 : knot - 1];
    codes[knot] = code_of_sigma(std::sqrt(before * sigma[knot]));
  }
  return codes;
}

}  // namespace roomcast::codec
