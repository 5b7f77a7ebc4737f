// SPDX-License-Identifier: Apache-2.0
// SIFT (Lowe 2004) by OpenCV, on a contrast-equalised picture, with RootSIFT descriptors. Only this
// unit uses OpenCV's detector. It sets OpenCV's process-wide thread count to one; otherwise
// thread-safe (no state).
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/feature/feature_set.h"
#include "roomcast/core/image.h"
#include "roomcast/core/option_fields.h"

namespace roomcast::alignment {

/// The first three are the prototype's for a whole picture; callers with other pictures change
/// them.
struct SiftOptions {
  int max_features = 6000;
  double min_contrast = 0.01;      // of a difference of Gaussians, grey 0..1
  double largest_edge_ratio = 20;  // of the curvatures across and along an edge
  int octave_layers = 3;           // Lowe 2004
  double clahe_limit = 2;          // of the contrast, for a tile's mean; OpenCV's example
  int clahe_tiles = 8;             // across and down; OpenCV's default

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_features", max_features, Range{1, 1e6});
    visit("min_contrast", min_contrast, Range{0, 1});
    visit("largest_edge_ratio", largest_edge_ratio, Range{1, 1000});
    visit("octave_layers", octave_layers, Range{1, 10});
    visit("clahe_limit", clahe_limit, Range{0.1, 100});
    visit("clahe_tiles", clahe_tiles, Range{1, 100});
  }
  [[nodiscard]] Status check() const { return check_fields("SiftOptions", *this); }
};

inline constexpr int kUsualMaxTilt = 3;

struct SiftFeature {
  Eigen::Vector2f pixel;
  float size = 0;  // pixels
  Descriptor descriptor;
};

/// The order depends on the picture only. `mask` (may be empty) is 0 where no features are wanted.
[[nodiscard]] std::vector<SiftFeature> detect_sift(ImageView<const std::uint8_t> grey,
                                                   MaskView mask, const SiftOptions& options);

/// The same on the picture and on simulated oblique views of it (affine SIFT: Morel & Yu 2009),
/// rotated and compressed by sqrt(2), 2 and so on, `max_tilt` steps. `options` apply to each view.
/// Coordinates are pixels of the original picture.
[[nodiscard]] std::vector<SiftFeature> detect_affine_sift(ImageView<const std::uint8_t> grey,
                                                          const SiftOptions& options,
                                                          int max_tilt = kUsualMaxTilt);

}  // namespace roomcast::alignment
