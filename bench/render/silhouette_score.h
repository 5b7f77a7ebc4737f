// SPDX-License-Identifier: Apache-2.0
// Whether people are drawn in one piece: what is missing of a silhouette, and what is drawn twice.
#pragma once

#include "bench/render/silhouette.h"
#include "bench/render/truth_view.h"
#include "roomcast/core/image.h"

namespace roomcast::bench {

/// Missing: pixels of the silhouette that show no surface, or one behind the true one. Doubled:
/// pixels of the silhouette or around it that show a surface before the true one, also where no
/// sensor sees the true one. Both by more than 6 cm or 3 %. Around it: Silhouette::reach_m.
struct SilhouetteErrors {
  MaskImage missing, doubled;
  /// Relative to the number of the silhouette's pixels; NaN where these are less than 0.1 % of the
  /// picture, or not known.
  double missing_share = 0, doubled_share = 0;
};

/// `drawn_m` as DrawnView::depth_m.
[[nodiscard]] SilhouetteErrors find_errors(const Image<float>& drawn_m, const TruthView& truth,
                                           const Silhouette& silhouette);

/// The drawn picture, in grey outside the silhouette; red where it is missing, blue where it is
/// doubled.
[[nodiscard]] ColorImage picture_of(const SilhouetteErrors& errors, const Silhouette& silhouette,
                                    const ColorImage& drawn);

}  // namespace roomcast::bench
