// SPDX-License-Identifier: Apache-2.0
// Two sensors' greys of the same surfaces: those of one view's points, and those of the other view
// at the same places. Thread-safe (no state).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/sensor_correction.h"

namespace roomcast::alignment {

/// Chosen on the development rooms (alignment_options.h).
struct ReprojectionOptions {
  float same_reading_sigmas = 10;  // of the depth noise: both views see the same surface
  double noise_contrast = 6;       // squared grey levels, in the denominator of a correlation:
                                   // faint texture correlates by chance
  // Of the same side of the same surface; by hand. Cosines: of its normal to the other's line of
  // sight, and between the normals of both readings.
  float min_facing = 0.1F, min_cosine = 0.3F;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("same_reading_sigmas", same_reading_sigmas, Range{0, 1000});
    visit("noise_contrast", noise_contrast, Range{1e-6, 1e5});
    visit("min_facing", min_facing, Range{-1, 1});
    visit("min_cosine", min_cosine, Range{-1, 1});
  }
  [[nodiscard]] Status check() const { return check_fields("ReprojectionOptions", *this); }
};

/// Two grey pictures on the same grid, valid where both are known.
struct ReprojectedViews {
  int width, height;
  std::vector<float> mine, theirs;
  std::vector<char> known;
  std::size_t count = 0;

  ReprojectedViews(int w, int h)
      : width(w),
        height(h),
        mine(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)),
        theirs(mine.size()),
        known(mine.size()) {}

  [[nodiscard]] std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/// A view with its sensor's colour correction applied.
class CorrectedView {
 public:
  CorrectedView(const SensorView& view, const SensorCorrection& correction)
      : view_(view), shift_px_(correction.color_shift_px.cast<float>()) {}

  [[nodiscard]] const SensorView& view() const { return view_; }
  [[nodiscard]] std::optional<float> grey_of(const Eigen::Vector3f& point_m) const;
  [[nodiscard]] std::optional<float> tint_of(const Eigen::Vector3f& point_m) const;
  /// Grey of one of the view's own points.
  [[nodiscard]] std::optional<float> grey_of(const TexturedPoint& point) const;

 private:
  /// Pixel of a point in the colour picture; nothing for points behind the camera.
  [[nodiscard]] std::optional<Eigen::Vector2f> pixel_of(const Eigen::Vector3f& point_m) const;

  const SensorView& view_;
  Eigen::Vector2f shift_px_;
};

/// On the grid of `from`; known where `other` sees the same surface unoccluded.
[[nodiscard]] ReprojectedViews reprojected_views(const CorrectedView& from,
                                                 const CorrectedView& other,
                                                 const RigidTransform& other_from_view,
                                                 const ReprojectionOptions& options = {});

/// Count and sums of x, y, xx, yy, xy.
using ReprojectionSums = std::array<double, 6>;

/// Adds a place with its grey in either picture.
void add_place(float mine, float theirs, ReprojectionSums& sums);

/// Sums over rectangles in constant time (Crow 1984).
class WindowSums {
 public:
  explicit WindowSums(const ReprojectedViews& reprojected_views);

  /// Sums over the window within `reach` of a place; places outside the picture do not count.
  [[nodiscard]] ReprojectionSums around(int x, int y, int reach) const;

 private:
  int width_, height_;
  std::vector<ReprojectionSums> sums_;
};

/// Standard deviations of both pictures in a window, and their covariance.
struct WindowContrast {
  double mine = 0, theirs = 0, together = 0;

  explicit WindowContrast(const ReprojectionSums& sums);
  /// -1..1; lowered for faint texture, which correlates by chance.
  [[nodiscard]] double correlation(const ReprojectionOptions& options = {}) const;
};

}  // namespace roomcast::alignment
