// SPDX-License-Identifier: Apache-2.0
// Registration: the paper's Algorithm 1 (Lesniak & Tucker 2018). Every depth pixel gets the colour
// that the colour camera saw at the same surface point, down-sampled to the depth grid. An
// occlusion test is added to the paper's algorithm, so that a surface hidden from the colour camera
// does not take the colour of the surface in front. Depth in millimetres. Single-threaded; one
// Registration per sensor.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/box_sampler.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/color_projection.h"
#include "roomcast/geometry/occlusion_grid.h"
#include "roomcast/geometry/quarter_positions.h"

namespace roomcast {

/// Colour in the depth grid, and a mask of its valid pixels.
struct RegisteredColor {
  ColorImage color;  // depth size, or twice that each way; black where `seen` is 0
  MaskImage seen;    // 255 where the colour camera saw this surface; 0 without depth, outside its
                     // picture, or occluded
};

struct RegistrationOptions {
  /// A surface further than this behind the nearest one in the same colour pixel is occluded:
  /// metres + share of its z.
  double occlusion_margin_m = 0.015;
  double occlusion_margin_per_m = 0.015;
  /// Colour pixels for each depth pixel and direction: 1, or 2 for four quarters of it.
  int color_scale = 1;
};

/// Precomputes everything that depends on the calibration only; `run` allocates nothing after its
/// first call.
class Registration {
 public:
  /// kInvalidArgument for cameras that CameraIntrinsics::check rejects, pictures of a single row or
  /// column, margins that are negative or not finite, a scale other than 1 or 2, and registered
  /// colour with a size other than that of depth or a scale of 2.
  static Result<Registration> create(const SensorCalibration& calibration,
                                     const RegistrationOptions& options = {});

  /// kInvalidArgument if the sizes are not those of the calibration.
  [[nodiscard]] Status run(DepthView depth_mm, ColorView color, RegisteredColor& out);

  /// Call after run() with the same depth and colour. Gives the colour of pixels without a reading
  /// as if their surface were at `filled_mm`, unless a surface that was read hides them.
  /// `filled_mm` equals the depth where there is a reading. In `out`, pixels with a reading and
  /// rows without a gap of several pixels are unseen.
  [[nodiscard]] Status run_in_holes(DepthView depth_mm, DepthView filled_mm, ColorView color,
                                    RegisteredColor& out);

 private:
  Registration(const SensorCalibration& calibration, const RegistrationOptions& options);

  [[nodiscard]] Status check_sizes(DepthView depth_mm, ColorView color) const;
  void make_room(RegisteredColor& out) const;
  void project_surfaces(DepthView depth_mm);
  void project_filled(DepthView filled_mm, int y);
  void limit_occluders(DepthView depth_mm, int y);
  void find_visible(int y, std::uint8_t* seen) const;
  void find_visible_holes(DepthView depth_mm, int y, std::uint8_t* seen) const;
  void sample(ColorView color, int y, RegisteredColor& out);
  void sample_row(ColorView color, int y, RegisteredColor& out) const;
  void sample_quarters(ColorView color, int y, RegisteredColor& out);

  int depth_width_, depth_height_, color_width_, color_height_;
  bool copy_only_;  // colour is already registered
  RegistrationOptions options_;
  ColorProjection projection_;
  ColorProjection::Spacing spacing_;
  OcclusionGrid grid_;
  SampleRow sample_row_;

  // Of the current frame, one per depth pixel.
  std::vector<float> u_, v_, z_m_;
  std::vector<float>
      occluder_limit_m_;  // a surface nearer than this in the colour picture hides the pixel
  std::vector<std::int32_t> cells_;

  // Of the current row, at a scale of 2.
  QuarterRow upper_, lower_;
  std::vector<std::uint8_t> seen_quarters_;
};

}  // namespace roomcast
