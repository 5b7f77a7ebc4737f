// SPDX-License-Identifier: Apache-2.0
// SensorView: everything that alignment derives from a calibration bundle: surface, picture,
// planes, floor, features. It takes half a second of CPU per sensor. All comparisons of two sensors
// use two SensorViews. Thread-safe (immutable after being made).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/alignment/feature/affine_features.h"
#include "roomcast/alignment/feature/feature_set.h"
#include "roomcast/alignment/feature/rectified_features.h"
#include "roomcast/alignment/view/color_picture.h"
#include "roomcast/alignment/view/depth_surface.h"
#include "roomcast/alignment/view/flat_normals.h"
#include "roomcast/alignment/view/floor.h"
#include "roomcast/alignment/view/planes.h"
#include "roomcast/alignment/view/texture.h"

namespace roomcast::alignment {

struct SensorViewOptions {
  BundleCheckOptions bundle;
  DepthSurfaceOptions surface;
  std::size_t min_samples = 200;  // of the surface; by hand
  ColorPictureOptions picture;
  TextureOptions texture;
  PlaneOptions planes;
  double max_on_one_plane = 0.97;  // of the samples; with more the pose is free along it. By hand
  FlatNormalOptions flat_normals;
  FloorOptions floor;
  LiftOptions lifting;
  SiftOptions picture_features;
  RectifiedFeatureOptions rectified_features;
  AffineFeatureOptions affine_features;
  RepeatOptions repeating;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("bundle", bundle);
    visit("surface", surface);
    visit("min_samples", min_samples, Range{1, 1e6});
    visit("picture", picture);
    visit("texture", texture);
    visit("planes", planes);
    visit("max_on_one_plane", max_on_one_plane, Range{0, 1});
    visit("flat_normals", flat_normals);
    visit("floor", floor);
    visit("lifting", lifting);
    visit("picture_features", picture_features);
    visit("rectified_features", rectified_features);
    visit("affine_features", affine_features);
    visit("repeating", repeating);
  }
  [[nodiscard]] Status check() const { return check_fields("SensorViewOptions", *this); }
};

struct SensorView {
  std::string name;
  DepthSurface surface;
  ColorPicture picture;
  Texture texture;
  std::vector<Plane> planes;
  std::optional<Plane> floor;
  FeatureSet picture_features, rectified_features;
  std::vector<DepthInstant> instants = {};  // of the bundle
  Image<Eigen::Vector2f> block_rays = {};   // through the middles of the instants' blocks
  SensorViewOptions options = {};           // with which it was made
  std::shared_ptr<const CalibrationBundle> bundle = nullptr;  // of which, if it has instants
};

/// Errors: those of `check`; kInvalidArgument when the sensor sees too little smooth surface or
/// only one plane.
[[nodiscard]] Result<SensorView> make_sensor_view(const CalibrationBundle& bundle,
                                                  const SensorViewOptions& options = {});

/// The view as it would be with all depth multiplied. Errors as above; kInvalidArgument: the view
/// does not have its bundle.
[[nodiscard]] Result<SensorView> with_depth_scale(const SensorView& view, double factor);

}  // namespace roomcast::alignment
