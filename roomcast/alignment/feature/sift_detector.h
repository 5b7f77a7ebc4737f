// SPDX-License-Identifier: Apache-2.0
// SIFT (Lowe 2004) as OpenCV has it, on a contrast-equalised picture, with RootSIFT descriptors.
// The only file that touches OpenCV's detector. One thread: OpenCV's
// thread count, which is the process's, is set to one. Thread-safe otherwise (no state).
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/feature/feature_set.h"
#include "roomcast/core/image.h"

namespace roomcast::alignment {

struct SiftOptions {
  int most_features = 6000;
  double least_contrast = 0.01;
  double largest_edge_ratio = 20;
};

struct SiftFeature {
  Eigen::Vector2f pixel;
  float size = 0;  // pixels
  Descriptor descriptor;
};

/// In an order that depends on the picture only. `mask` (may be empty) is 0 where nothing is
/// sought.
[[nodiscard]] std::vector<SiftFeature> detect_sift(ImageView<const std::uint8_t> grey,
                                                   MaskView mask, const SiftOptions& options);

/// The same in the picture as it is and as it would look from aside (affine SIFT: Morel & Yu 2009):
/// turned and pressed together by sqrt(2), 2 and 2 sqrt(2). `options` hold for each of these. In
/// the picture's own pixels.
[[nodiscard]] std::vector<SiftFeature> detect_affine_sift(ImageView<const std::uint8_t> grey,
                                                          const SiftOptions& options);

}  // namespace roomcast::alignment
