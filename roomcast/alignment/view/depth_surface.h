// SPDX-License-Identifier: Apache-2.0
// The surface seen in one depth picture: raw readings and, where the surface is smooth, points with
// normals. Points near depth edges have no normal and are no samples, because flying pixels occur
// there. Metres, in the depth camera's frame. Thread-safe (immutable after being made).
#pragma once

#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/view/depth_noise.h"
#include "roomcast/alignment/view/lens.h"
#include "roomcast/alignment/view/window_range.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::alignment {

struct SurfacePoint {
  Eigen::Vector3f point_m;
  Eigen::Vector3f normal;  // unit, towards the camera
};

inline constexpr int kSmoothReach = 2;  // pixels: radius of the bilateral filter, an unrolled loop
inline constexpr float kNearestSurface_m = 0.3F;

/// Chosen on the development rooms (alignment_options.h), unless noted.
struct DepthSurfaceOptions {
  DepthNoiseOptions noise;
  float nearest_m = kNearestSurface_m;  // nearer readings are errors: a Kinect v2 begins at 0.5 m
  float farthest_m = 7;     // 4.5 m lost what tells a repeating floor's periods apart (house3)
  float smooth_sigmas = 4;  // of noise; readings that differ by more are another surface
  int normal_reach_px = 3;  // from a point to the neighbours that give its normal
  float max_range_per_depth = 0.06F;  // a larger range of depth within that reach is an edge
  float min_incidence = 0.2F;         // cosine; readings at flatter angles are unreliable
  int sample_step_px = 3;             // rows and columns from sample to sample

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("noise", noise);
    visit("nearest_m", nearest_m, Range{0.05, 10});
    visit("farthest_m", farthest_m, Range{0.1, 65});
    visit("smooth_sigmas", smooth_sigmas, Range{0.1, 100});
    visit("normal_reach_px", normal_reach_px, Range{kSmoothReach, 50});
    visit("max_range_per_depth", max_range_per_depth, Range{0, 1});
    visit("min_incidence", min_incidence, Range{0, 1});
    visit("sample_step_px", sample_step_px, Range{1, 100});
  }
  [[nodiscard]] Status check() const {
    if (Status status = check_fields("DepthSurfaceOptions", *this); !status) return status;
    return check_at_most("DepthSurfaceOptions", "nearest_m", double(nearest_m), "farthest_m",
                         double(farthest_m));
  }
};

struct DepthSurface {
  CameraIntrinsics camera;
  Lens lens;
  Image<float> z_m;                   // raw readings; 0 = none
  WindowRange range;                  // of the readings around each pixel
  Image<SurfacePoint> at;             // smoothed; the normal is 0 where the surface is not smooth
  std::vector<SurfacePoint> samples;  // the smooth points of every n-th row and column
  DepthSurfaceOptions options = {};   // with which it was made
};

/// `depth_mm` has the size of `camera`, which must have been checked.
[[nodiscard]] DepthSurface depth_surface(DepthView depth_mm, const CameraIntrinsics& camera,
                                         const DepthSurfaceOptions& options = {});

}  // namespace roomcast::alignment
