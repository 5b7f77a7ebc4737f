// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/sensor_view.h"

#include <utility>

#include "roomcast/alignment/feature/picture_features.h"
#include "roomcast/alignment/feature/rectified_features.h"
#include "roomcast/alignment/feature/repeats.h"
#include "roomcast/alignment/view/flat_normals.h"
#include "roomcast/alignment/view/floor.h"

namespace roomcast::alignment {
namespace {

constexpr std::size_t kMinSurfaceSamples = 200;
constexpr double kAllOnOnePlane = 0.97;  // of the samples; the pose is then free along it

bool sees_one_plane_only(const std::vector<Plane>& planes, std::size_t samples) {
  return planes.size() == 1 && static_cast<double>(planes[0].points_m.size()) >
                                   kAllOnOnePlane * static_cast<double>(samples);
}

}  // namespace

Result<SensorView> make_sensor_view(const CalibrationBundle& bundle) {
  if (const Status status = check(bundle); !status) return status.error();
  DepthSurface surface = depth_surface(bundle.depth_mm, bundle.calibration.depth);
  if (surface.samples.size() < kMinSurfaceSamples) {
    return Error{ErrorCode::kInvalidArgument,
                 "sensor " + bundle.name +
                     " sees too few surfaces; turn it towards walls, floor or furniture "
                     "between 0.5 and 5 m away"};
  }
  ColorPicture picture = color_picture(bundle.color, bundle.calibration, surface);
  Texture texture = make_texture(surface, picture);
  std::vector<Plane> planes = find_planes(surface.samples);
  if (sees_one_plane_only(planes, surface.samples.size())) {
    return Error{ErrorCode::kInvalidArgument,
                 "sensor " + bundle.name +
                     " sees only one flat surface; turn it so that a corner or furniture "
                     "comes into its view"};
  }
  flatten_normals(planes, surface);
  auto floor = find_floor(planes, surface.samples, bundle.up);
  FeatureSet in_picture = picture_features(picture, surface);
  FeatureSet on_planes = rectified_features(picture, surface, planes);
  compute_ambiguity(in_picture);
  compute_ambiguity(on_planes);
  return SensorView{bundle.name,           std::move(surface),  std::move(picture),
                    std::move(texture),    std::move(planes),   std::move(floor),
                    std::move(in_picture), std::move(on_planes)};
}

}  // namespace roomcast::alignment
