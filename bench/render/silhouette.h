// SPDX-License-Identifier: Apache-2.0
// What stands before the still background in a true view: people, and what they carry. A pixel
// belongs to this silhouette if some sensor sees its surface now, and the surface is nearer to that
// sensor than everything that stays there, by more than 6 cm or 3 %. So people who do not move
// during the whole recording are part of the background, and have no silhouette.
#pragma once

#include <span>

#include "bench/render/truth_view.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::bench {

struct Silhouette {
  MaskImage mask;
  /// Up to which depth something drawn can be a second image of the silhouette: 0.3 m behind the
  /// silhouette's nearest pixel. 0: more than 0.3 m beside it (at its median depth). So still
  /// surfaces that are drawn wrong far behind people are not mistaken for people.
  Image<float> reach_m;
};

/// The farthest that one sensor ever sees in each of its pixels. Its noise-free depth lacks a
/// reading only where no surface is in the way: there the background is open, farther than all.
class StillBackground {
 public:
  StillBackground(const SensorCalibration& calibration, const RigidTransform& world_from_depth);

  /// Takes the noise-free depth of one more frame; its size is that of the depth camera.
  void add(DepthView noise_free_mm);
  /// At edges the nearest background counts, so that a still edge is not before itself. False
  /// outside the picture, and before any frame was taken.
  [[nodiscard]] bool is_behind(const Eigen::Vector3d& point_world) const;

 private:
  [[nodiscard]] double nearest_m(int x, int y) const;

  CameraIntrinsics lens_;
  RigidTransform depth_from_world_;
  DepthImage farthest_mm_;
};

/// `backgrounds`: of all sensors, in the order of the bits of TruthView::seen.
[[nodiscard]] Silhouette find_silhouette(const render::ViewCamera& camera, const TruthView& truth,
                                         std::span<const StillBackground> backgrounds);

}  // namespace roomcast::bench
