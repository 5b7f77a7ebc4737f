// SPDX-License-Identifier: Apache-2.0
// Similarity of a drawn picture to the truth. PSNR over the three channels, in dB; SSIM of the grey
// picture (Wang et al. 2004: 11x11 Gaussian of 1.5 pixels), mean over the class. A floater is a
// drawn point in front of the true surface by more than 6 cm or 3 %. Wrong depth is a difference of
// more than that in either direction. Silhouettes are judged as in silhouette_score.h.
#pragma once

#include "bench/render/truth_view.h"
#include "bench/render/view_classes.h"
#include "roomcast/core/image.h"

namespace roomcast::bench {

struct DrawnView {
  ColorImage color;      // holes as drawn
  Image<float> depth_m;  // 0: no surface was drawn (a filled hole)
};

struct ViewScore {
  double psnr_all = 0, ssim_all = 0;  // all pixels, also surfaces that no sensor ever sees
  double psnr_covered = 0, ssim_covered = 0;
  double psnr_visible = 0, ssim_visible = 0;  // surfaces that a sensor sees now, holes as drawn
  double psnr_colored = 0, ssim_colored = 0;  // the same where a colour camera sees the surface
  double psnr_moving = 0;  // surfaces that a sensor sees now; NaN where nothing moves
  double holes = 0, floaters = 0, wrong_depth = 0;        // shares of the visible pixels
  double covered = 0;                                     // share of the picture
  double silhouette_missing = 0, silhouette_doubled = 0;  // NaN where there is no silhouette
};

[[nodiscard]] ViewScore score(const DrawnView& drawn, const TruthView& truth,
                              const ViewClasses& classes);

/// Mean over views; each field over the views in which it is a number, NaN where there is none.
[[nodiscard]] ViewScore mean(const std::vector<ViewScore>& scores);

/// Mean absolute difference, in grey levels, over static seen pixels that are drawn in both
/// pictures.
[[nodiscard]] double flicker(const DrawnView& a, const DrawnView& b, const TruthView& truth,
                             const ViewClasses& classes);

}  // namespace roomcast::bench
