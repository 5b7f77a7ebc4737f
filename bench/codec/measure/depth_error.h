// SPDX-License-Identifier: Apache-2.0
// Error of decoded depth against the input and, where they are known, against the ground truth and
// the sensor's noise-free reading. Millimetres.
// A pixel that is off by more than 20 mm is an outlier. Outliers are counted and left out of the
// root mean squares, which they would dominate.
#pragma once

#include <array>
#include <cstdint>

#include "bench/codec/measure/truth_motion.h"
#include "roomcast/core/image.h"

namespace roomcast::bench {

inline constexpr int kOutlier_mm = 20;

/// Ground truth of one frame; empty views where it is unknown.
struct DepthTruth {
  DepthView depth_mm;
  ImageView<const Motion> motion;
  DepthView noise_free_mm = {};  // may be empty although the others are not
  DepthView still_mm = {};       // likewise; 0 where the surface is not still
};

/// Sums over the pixels of all added frames.
class DepthError {
 public:
  /// Adds one frame.
  void add(DepthView decoded_mm, DepthView input_mm, const DepthTruth& truth);
  void add(const DepthError& other);

  [[nodiscard]] bool has_truth() const { return has_truth_; }

  /// Over pixels with a reading in both.
  [[nodiscard]] double rms_input_mm() const { return input_.rms(); }
  [[nodiscard]] int max_input_mm() const { return max_input_mm_; }
  /// Over pixels that have a reading and a known truth; 0 if there are none.
  [[nodiscard]] double rms_truth_mm() const;
  [[nodiscard]] double rms_truth_mm(Motion motion) const { return of(motion).rms(); }

  /// The same, over pixels that the sensor can read, against its noise-free reading.
  [[nodiscard]] bool has_noise_free() const { return has_noise_free_; }
  [[nodiscard]] double rms_noise_free_mm(Motion motion) const {
    return noise_free_[static_cast<std::size_t>(motion)].rms();
  }

  /// Error against the median of still surfaces, of the output and of the input, over pixels with a
  /// reading in both. Noise of structured light exceeds 20 mm: an error counts for at most
  /// kStillShare of the distance, and none is left out.
  [[nodiscard]] bool has_still() const { return has_still_; }
  [[nodiscard]] double rms_still_mm() const { return still_.rms(); }
  [[nodiscard]] double rms_still_input_mm() const { return still_input_.rms(); }

  /// Pixels in all frames; against the truth where it is known, else against the input.
  [[nodiscard]] std::int64_t outliers() const;
  [[nodiscard]] std::int64_t outliers(Motion motion) const { return of(motion).outliers; }
  /// Pixels with a known truth, whether decoded or not.
  [[nodiscard]] std::int64_t true_pixels(Motion motion) const { return of(motion).pixels; }
  /// Pixels with a reading only in the input, and pixels with a reading only in the output.
  [[nodiscard]] std::int64_t lost() const { return lost_; }
  [[nodiscard]] std::int64_t extra() const { return extra_; }

 private:
  struct Sums {
    double squares = 0;
    std::int64_t count = 0, outliers = 0, pixels = 0;
    void add(int error_mm);
    void add(const Sums& other);
    void add_at_most(double error_mm, double most_mm);
    [[nodiscard]] double rms() const;
  };
  void compare(int decoded_mm, int input_mm);
  void compare_still(DepthView decoded_mm, DepthView input_mm, DepthView still_mm);
  void compare_noise_free(DepthView decoded_mm, const DepthTruth& truth);
  [[nodiscard]] const Sums& of(Motion motion) const {
    return truth_[static_cast<std::size_t>(motion)];
  }

  Sums input_, still_, still_input_;
  std::array<Sums, kMotionCount> truth_, noise_free_;
  int max_input_mm_ = 0;
  std::int64_t lost_ = 0, extra_ = 0;
  bool has_truth_ = false, has_noise_free_ = false, has_still_ = false;
};

}  // namespace roomcast::bench
