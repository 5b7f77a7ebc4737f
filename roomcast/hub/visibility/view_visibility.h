// SPDX-License-Identifier: Apache-2.0
// Judges whether a viewer can see a surface: whether the surface is within the cone or pyramid of
// the viewer's view, and on which side of the surface the viewer is. A sensor that
// looks from the other side shows nothing that the viewer sees. Occlusion is ignored. View culling
// as such is usual in volumetric video (ViVo, MobiCom 2020; LiVo, CoNEXT 2025); here it needs no
// decoded frame. Pure.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "roomcast/geometry/view_cone.h"
#include "roomcast/hub/visibility/detail.h"
#include "roomcast/hub/visibility/seen_surface.h"

namespace roomcast::hub {

/// A sensor is needed if so much of its surface is seen, with these margins.
struct VisibilityNeed {
  float beside_rad = 0;  // around the view
  /// The largest angle at a point between the directions to the sensor and to the viewer. A surface
  /// that faces the sensor can be seen at a right angle more.
  float facing_rad = 0;
  float enough = 0;  // share of the sensor's points
};

struct VisibilityOptions {
  VisibilityNeed all{0.14F, 1.75F, 0.1F};         // 8 and 100 degrees: for Detail::kAll
  VisibilityNeed base_only{0.52F, 2.1F, 0.015F};  // 30 and 120 degrees: for Detail::kBaseOnly
  /// Share of the sensor's points that move and are seen: enough for Detail::kAll, whoever shows
  /// them better. People take few cells, and are what viewers look at.
  float enough_moving = 0.03F;
  /// By so much must the cosine of another sensor's angle be larger, so that the other shows a
  /// point better and this one is needed for it in its base only.
  float better = 0.05F;
};

/// The detail in which this surface is needed, for a viewer who has one of these views, world
/// frame: now, and some moments ahead.
[[nodiscard]] Detail needed_detail(const SeenSurface& surface, const std::vector<ViewCone>& views,
                                   const VisibilityOptions& options);

}  // namespace roomcast::hub
