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

namespace roomcast::alignment {

struct SiftOptions {
  int max_features = 6000;
  double min_contrast = 0.01;
  double largest_edge_ratio = 20;
};

struct SiftFeature {
  Eigen::Vector2f pixel;
  float size = 0;  // pixels
  Descriptor descriptor;
};

/// The order depends on the picture only. `mask` (may be empty) is 0 where no features are wanted.
[[nodiscard]] std::vector<SiftFeature> detect_sift(ImageView<const std::uint8_t> grey,
                                                   MaskView mask, const SiftOptions& options);

/// The same on the picture and on simulated oblique views of it (affine SIFT: Morel & Yu 2009),
/// rotated and compressed by sqrt(2), 2 and 2 sqrt(2). `options` apply to each view. Coordinates
/// are pixels of the original picture.
[[nodiscard]] std::vector<SiftFeature> detect_affine_sift(ImageView<const std::uint8_t> grey,
                                                          const SiftOptions& options);

}  // namespace roomcast::alignment
