// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/sensor_view.h"

#include <utility>

#include "roomcast/alignment/feature/picture_features.h"
#include "roomcast/core/depth_factor.h"

namespace roomcast::alignment {
namespace {

bool sees_one_plane_only(const std::vector<Plane>& planes, std::size_t samples,
                         double max_on_one_plane) {
  return planes.size() == 1 && static_cast<double>(planes[0].points_m.size()) >
                                   max_on_one_plane * static_cast<double>(samples);
}

Image<Eigen::Vector2f> block_rays(const CameraIntrinsics& camera) {
  const Image<Eigen::Vector2f> rays = ray_table(camera);
  Image<Eigen::Vector2f> of_blocks(camera.width / kInstantBlock, camera.height / kInstantBlock,
                                   Eigen::Vector2f::Zero());
  for (int y = 0; y < of_blocks.height(); ++y) {
    for (int x = 0; x < of_blocks.width(); ++x)
      of_blocks.at(x, y) =
          rays.at(kInstantBlock * x + kInstantBlock / 2, kInstantBlock * y + kInstantBlock / 2);
  }
  return of_blocks;
}

}  // namespace

Result<SensorView> make_sensor_view(const CalibrationBundle& bundle,
                                    const SensorViewOptions& options) {
  if (const Status status = check(bundle, options.bundle); !status) return status.error();
  DepthSurface surface = depth_surface(bundle.depth_mm, bundle.calibration.depth, options.surface);
  if (surface.samples.size() < options.min_samples) {
    return Error{ErrorCode::kInvalidArgument,
                 "sensor " + bundle.name +
                     " sees too few surfaces; turn it towards walls, floor or furniture "
                     "between 0.5 and 5 m away"};
  }
  ColorPicture picture = color_picture(bundle.color, bundle.calibration, surface, options.picture);
  Texture texture = make_texture(surface, picture, options.texture);
  std::vector<Plane> planes = find_planes(surface.samples, options.planes);
  if (sees_one_plane_only(planes, surface.samples.size(), options.max_on_one_plane)) {
    return Error{ErrorCode::kInvalidArgument,
                 "sensor " + bundle.name +
                     " sees only one flat surface; turn it so that a corner or furniture "
                     "comes into its view"};
  }
  flatten_normals(planes, surface, options.flat_normals);
  auto floor = find_floor(planes, surface.samples, bundle.up, options.floor);
  FeatureSet in_picture =
      picture_features(picture, surface, options.picture_features, options.lifting);
  FeatureSet on_planes = rectified_features(picture, surface, planes, options.rectified_features);
  compute_ambiguity(in_picture, options.repeating);
  compute_ambiguity(on_planes, options.repeating);
  return SensorView{
      bundle.name,
      std::move(surface),
      std::move(picture),
      std::move(texture),
      std::move(planes),
      std::move(floor),
      std::move(in_picture),
      std::move(on_planes),
      bundle.instants,
      block_rays(bundle.calibration.depth),
      options,
      bundle.instants.empty() ? nullptr : std::make_shared<const CalibrationBundle>(bundle)};
}

Result<SensorView> with_depth_scale(const SensorView& view, double factor) {
  if (!view.bundle) {
    return Error{ErrorCode::kInvalidArgument,
                 "the readings of sensor " + view.name + " are no longer known"};
  }
  CalibrationBundle bundle = *view.bundle;
  bundle.name = view.name;  // a view may have been given another name than its bundle's
  multiply_depth(bundle.depth_mm.view(), factor);
  for (DepthInstant& instant : bundle.instants) multiply_depth(instant.depth_mm.view(), factor);
  return make_sensor_view(bundle, view.options);
}

}  // namespace roomcast::alignment
