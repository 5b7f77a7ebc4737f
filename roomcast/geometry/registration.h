// SPDX-License-Identifier: Apache-2.0
// Registration: the paper's Algorithm 1 (Lesniak & Tucker 2018): every depth pixel gets the colour
// that the colour camera saw at the same surface point. Colour is down-sampled to the depth grid.
// Added to the paper's algorithm: an occlusion test, so that a surface hidden from the colour
// camera does not take the colour of what hides it. Depth in millimetres. Single-threaded; one
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

/// Colour in the depth grid, and where it is to be believed.
struct RegisteredColor {
  ColorImage color;  // depth size, or twice that each way; black where `seen` is 0
  MaskImage seen;    // 255 where the colour camera saw this surface; 0 without depth, outside its
                     // picture, or occluded
};

struct RegistrationOptions {
  /// A surface this much behind the nearest one in the same colour pixel is occluded: metres +
  /// share of its z.
  double occlusion_margin_m = 0.015;
  double occlusion_margin_per_m = 0.015;
  /// Colour pixels for each depth pixel and direction: 1, or 2 for four quarters of it.
  int color_scale = 1;
};

/// Precomputes what depends on the calibration only; `run` allocates nothing after its first call.
class Registration {
 public:
  /// kInvalidArgument for cameras that CameraIntrinsics::check refuses, pictures of a single row or
  /// column, margins that are negative or not finite, another scale than 1 or 2, and for registered
  /// colour of another size than depth or a scale of 2.
  static Result<Registration> create(const SensorCalibration& calibration,
                                     const RegistrationOptions& options = {});

  /// kInvalidArgument when the sizes are not those of the calibration.
  [[nodiscard]] Status run(DepthView depth_mm, ColorView color, RegisteredColor& out);

  /// After run() with the same depth and colour: the colour of pixels without a reading, if their
  /// surface were where `filled_mm` says, as far as nothing that was read hides it. `filled_mm` is
  /// that depth where it has a reading. `out` is unseen at pixels with one, and in rows without a
  /// gap of several.
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
  bool copy_only_;  // colour comes registered
  RegistrationOptions options_;
  ColorProjection projection_;
  ColorProjection::Spacing spacing_;
  OcclusionGrid grid_;
  SampleRow sample_row_;

  // Of the current frame, one per depth pixel.
  std::vector<float> u_, v_, z_m_;
  std::vector<float>
      occluder_limit_m_;  // what is nearer than this in the colour picture hides the pixel
  std::vector<std::int32_t> cells_;

  // Of the current row, at a scale of 2.
  QuarterRow upper_, lower_;
  std::vector<std::uint8_t> seen_quarters_;
};

}  // namespace roomcast
