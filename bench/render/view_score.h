// SPDX-License-Identifier: Apache-2.0
// How a drawn picture compares with the truth. PSNR over the three channels, in dB; SSIM of the
// grey picture (Wang et al. 2004: 11x11 Gaussian of 1.5 pixels), mean over the class. A floater is
// a drawn point that lies in front of the true surface by more than 6 cm or 3 %, wrong depth is
// more than that on either side.
#pragma once

#include "bench/render/truth_view.h"
#include "bench/render/view_classes.h"
#include "roomcast/core/image.h"

namespace roomcast::bench {

struct DrawnView {
  ColorImage color;      // holes as they look
  Image<float> depth_m;  // 0: no surface was drawn (a filled hole)
};

struct ViewScore {
  double psnr_all = 0, ssim_all = 0;  // also of what no sensor ever sees, which can only be guessed
  double psnr_covered = 0, ssim_covered = 0;
  double psnr_visible = 0, ssim_visible = 0;  // what a sensor sees now, holes as they look
  double psnr_colored = 0, ssim_colored = 0;  // the same where a colour camera sees it
  double psnr_moving = 0;  // of what a sensor sees now; not a number where nothing moves
  double holes = 0, floaters = 0, wrong_depth = 0;  // shares of the visible
  double covered = 0;                               // share of the picture
};

[[nodiscard]] ViewScore score(const DrawnView& drawn, const TruthView& truth,
                              const ViewClasses& classes);

/// Mean over views, each field over those in which it is a number.
[[nodiscard]] ViewScore mean(const std::vector<ViewScore>& scores);

/// Mean absolute difference, in grey levels, of what is drawn in both pictures, seen and still.
[[nodiscard]] double flicker(const DrawnView& a, const DrawnView& b, const TruthView& truth,
                             const ViewClasses& classes);

}  // namespace roomcast::bench
