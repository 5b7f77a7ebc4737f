// SPDX-License-Identifier: Apache-2.0
// How far decoded depth is from the input, and from the truth where it is known. Millimetres.
#pragma once

#include <cstdint>
#include <optional>

#include "roomcast/core/image.h"

namespace roomcast::bench {

/// Off by more than this, a reading is an outlier: it counts as one and is left out of the means.
inline constexpr int kOutlier_mm = 20;

/// Sums over frames; ask for the means at the end.
class DepthError {
 public:
  /// `truth_mm` and `previous_truth_mm` may be empty views. A pixel moves where the truth changed
  /// by more than 5 mm.
  void add(DepthView decoded_mm, DepthView input_mm, DepthView truth_mm,
           DepthView previous_truth_mm);

  /// Over pixels with a reading in both.
  [[nodiscard]] double rms_input_mm() const { return input_.rms(); }
  [[nodiscard]] int max_input_mm() const { return max_input_mm_; }
  /// Against the truth: nothing where none is known.
  [[nodiscard]] std::optional<double> rms_truth_mm() const;
  [[nodiscard]] std::optional<double> rms_truth_static_mm() const;
  [[nodiscard]] std::optional<double> rms_truth_moving_mm() const;
  /// Per frame; against the truth where it is known, else against the input.
  [[nodiscard]] double outliers_per_frame() const;

 private:
  struct Squares {
    double sum = 0;
    std::int64_t count = 0;
    void add(int error) {
      sum += static_cast<double>(error) * error;
      ++count;
    }
    [[nodiscard]] double rms() const;
  };
  void add_to_truth(int error, bool moving);

  Squares input_, truth_static_, truth_moving_;
  int max_input_mm_ = 0;
  std::int64_t input_outliers_ = 0, truth_outliers_ = 0;
  int frames_ = 0;
  bool has_truth_ = false;
};

}  // namespace roomcast::bench
