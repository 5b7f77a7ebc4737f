// SPDX-License-Identifier: Apache-2.0
// Plane-rectified SIFT (viewpoint-invariant patches, Wu et al. 2008): every large plane is rendered
// face-on at one metric scale, and SIFT features are detected there. They match across viewing
// angles at which features of the picture do not, and they have a size in metres. Thread-safe (no
// state).
#pragma once

#include <span>

#include "roomcast/alignment/feature/feature_set.h"
#include "roomcast/alignment/feature/plane_relief.h"
#include "roomcast/alignment/feature/sift_detector.h"
#include "roomcast/alignment/view/color_picture.h"
#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {

/// Chosen on the development rooms (alignment_options.h), unless noted.
struct RectifiedFeatureOptions {
  /// Pixels of the rectified picture: at least this large, and this share of what a pixel of the
  /// colour picture covers where the plane is near. With 6 mm the kitchen loses three pairs (ADR
  /// 13).
  float min_pixel_m = 0.004F, pixel_share = 0.7F;
  float near_share = 0.1F;         // of a plane's points: those that count as near
  float margin_m = 0.05F;          // around the plane's points
  float outermost_share = 0.005F;  // of the points: cut off on every side, as outliers
  int max_side_px = 1600;          // of the rectified picture, for time and memory; by hand
  int min_side_px = 60;            // smaller pictures have no features; by hand
  /// Surfaces further from the plane are not part of it: a constant, and a share of depth.
  float on_plane_m = 0.05F, on_plane_per_depth = 0.01F;
  int closing_px = 7;  // closes pinholes of the mask; by hand
  SiftOptions sift{.max_features = 2500, .min_contrast = 0.012, .largest_edge_ratio = 15};
  PlaneReliefOptions relief;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("min_pixel_m", min_pixel_m, Range{1e-4, 1});
    visit("pixel_share", pixel_share, Range{0, 100});
    visit("near_share", near_share, Range{0, 0.99});
    visit("margin_m", margin_m, Range{0, 10});
    visit("outermost_share", outermost_share, Range{0, 0.49});
    visit("max_side_px", max_side_px, Range{16, 10000});
    visit("min_side_px", min_side_px, Range{1, 10000});
    visit("on_plane_m", on_plane_m, Range{0, 1});
    visit("on_plane_per_depth", on_plane_per_depth, Range{0, 1});
    visit("closing_px", closing_px, Range{1, 100});
    visit("sift", sift);
    visit("relief", relief);
  }
  [[nodiscard]] Status check() const { return check_fields("RectifiedFeatureOptions", *this); }
};

[[nodiscard]] FeatureSet rectified_features(const ColorPicture& picture,
                                            const DepthSurface& surface,
                                            std::span<const Plane> planes,
                                            const RectifiedFeatureOptions& options = {});

}  // namespace roomcast::alignment
