// SPDX-License-Identifier: Apache-2.0
#include "bench/depth_error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace roomcast::bench {
namespace {

constexpr int kMoving_mm = 5;

bool moves(DepthView truth, DepthView before, int x, int y) {
  return before.data != nullptr && std::abs(truth.at(x, y) - before.at(x, y)) > kMoving_mm;
}

}  // namespace

double DepthError::Squares::rms() const {
  return count ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

void DepthError::add(DepthView decoded_mm, DepthView input_mm, DepthView truth_mm,
                     DepthView previous_truth_mm) {
  ++frames_;
  has_truth_ |= truth_mm.data != nullptr;
  for (int y = 0; y < decoded_mm.height; ++y) {
    for (int x = 0; x < decoded_mm.width; ++x) {
      const int decoded = decoded_mm.at(x, y), input = input_mm.at(x, y);
      if (decoded == 0) continue;
      if (input != 0) {
        const int error = std::abs(decoded - input);
        input_.add(error);
        max_input_mm_ = std::max(max_input_mm_, error);
        input_outliers_ += error > kOutlier_mm;
      }
      if (truth_mm.data != nullptr && truth_mm.at(x, y) != 0) {
        add_to_truth(std::abs(decoded - truth_mm.at(x, y)),
                     moves(truth_mm, previous_truth_mm, x, y));
      }
    }
  }
}

void DepthError::add_to_truth(int error, bool moving) {
  if (error > kOutlier_mm) {
    ++truth_outliers_;
  } else {
    (moving ? truth_moving_ : truth_static_).add(error);
  }
}

std::optional<double> DepthError::rms_truth_mm() const {
  if (!has_truth_) return std::nullopt;
  return Squares{truth_static_.sum + truth_moving_.sum, truth_static_.count + truth_moving_.count}
      .rms();
}

std::optional<double> DepthError::rms_truth_static_mm() const {
  if (!has_truth_) return std::nullopt;
  return truth_static_.rms();
}

std::optional<double> DepthError::rms_truth_moving_mm() const {
  if (!has_truth_) return std::nullopt;
  return truth_moving_.rms();
}

double DepthError::outliers_per_frame() const {
  const std::int64_t outliers = has_truth_ ? truth_outliers_ : input_outliers_;
  return frames_ ? static_cast<double>(outliers) / frames_ : 0;
}

}  // namespace roomcast::bench
