// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/measure/depth_error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "bench/codec/measure/still_surfaces.h"

namespace roomcast::bench {

void DepthError::Sums::add(int error_mm) {
  if (error_mm > kOutlier_mm) {
    ++outliers;
    return;
  }
  squares += static_cast<double>(error_mm) * error_mm;
  ++count;
}

void DepthError::Sums::add_at_most(double error_mm, double most_mm) {
  const double error = std::min(std::abs(error_mm), most_mm);
  squares += error * error;
  ++count;
}

void DepthError::Sums::add(const Sums& other) {
  squares += other.squares;
  count += other.count;
  outliers += other.outliers;
  pixels += other.pixels;
}

double DepthError::Sums::rms() const {
  return count ? std::sqrt(squares / static_cast<double>(count)) : 0;
}

void DepthError::add(DepthView decoded_mm, DepthView input_mm, const DepthTruth& truth) {
  const bool known = truth.depth_mm.data != nullptr;
  has_truth_ |= known;
  if (truth.noise_free_mm.data != nullptr) compare_noise_free(decoded_mm, truth);
  if (truth.still_mm.data != nullptr) compare_still(decoded_mm, input_mm, truth.still_mm);
  for (int y = 0; y < decoded_mm.height; ++y) {
    for (int x = 0; x < decoded_mm.width; ++x) {
      const int decoded = decoded_mm.at(x, y);
      compare(decoded, input_mm.at(x, y));
      if (!known || truth.depth_mm.at(x, y) == 0) continue;
      Sums& sums = truth_[static_cast<std::size_t>(truth.motion.at(x, y))];
      ++sums.pixels;
      if (decoded != 0) sums.add(std::abs(decoded - truth.depth_mm.at(x, y)));
    }
  }
}

void DepthError::compare_still(DepthView decoded_mm, DepthView input_mm, DepthView still_mm) {
  has_still_ = true;
  for (int y = 0; y < decoded_mm.height; ++y) {
    for (int x = 0; x < decoded_mm.width; ++x) {
      const int still = still_mm.at(x, y), decoded = decoded_mm.at(x, y), input = input_mm.at(x, y);
      if (still == 0 || decoded == 0 || input == 0) continue;
      still_.add_at_most(decoded - still, kStillShare * still);
      still_input_.add_at_most(input - still, kStillShare * still);
    }
  }
}

void DepthError::compare_noise_free(DepthView decoded_mm, const DepthTruth& truth) {
  has_noise_free_ = true;
  for (int y = 0; y < decoded_mm.height; ++y) {
    for (int x = 0; x < decoded_mm.width; ++x) {
      const int decoded = decoded_mm.at(x, y), wanted = truth.noise_free_mm.at(x, y);
      if (decoded == 0 || wanted == 0 || truth.depth_mm.at(x, y) == 0) continue;
      noise_free_[static_cast<std::size_t>(truth.motion.at(x, y))].add(std::abs(decoded - wanted));
    }
  }
}

void DepthError::compare(int decoded_mm, int input_mm) {
  lost_ += input_mm != 0 && decoded_mm == 0;
  extra_ += input_mm == 0 && decoded_mm != 0;
  if (input_mm == 0 || decoded_mm == 0) return;
  const int error_mm = std::abs(decoded_mm - input_mm);
  input_.add(error_mm);
  max_input_mm_ = std::max(max_input_mm_, error_mm);
}

void DepthError::add(const DepthError& other) {
  input_.add(other.input_);
  still_.add(other.still_);
  still_input_.add(other.still_input_);
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    truth_[i].add(other.truth_[i]);
    noise_free_[i].add(other.noise_free_[i]);
  }
  max_input_mm_ = std::max(max_input_mm_, other.max_input_mm_);
  lost_ += other.lost_;
  extra_ += other.extra_;
  has_truth_ |= other.has_truth_;
  has_noise_free_ |= other.has_noise_free_;
  has_still_ |= other.has_still_;
}

double DepthError::rms_truth_mm() const {
  Sums all;
  for (const Sums& sums : truth_) all.add(sums);
  return all.rms();
}

std::int64_t DepthError::outliers() const {
  if (!has_truth_) return input_.outliers;
  std::int64_t outliers = 0;
  for (const Sums& sums : truth_) outliers += sums.outliers;
  return outliers;
}

}  // namespace roomcast::bench
