// SPDX-License-Identifier: Apache-2.0
// Gains of the views' colours: cameras with exposures and white balances of their own show a wall
// that two of them see in two colours. Each view gets a factor for each channel, so that the
// surfaces it shares with others look the same in all; their mean stays as it is. Robust against
// surfaces that shine, and against clipped colours. Thread-safe (no state).
// Source: geometry/color_balance.h, over the medians of pairs of views.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/parallel_rows.h"
#include "roomcast/model/model_options.h"
#include "roomcast/model/room_mesh.h"
#include "roomcast/model/view_surface.h"

namespace roomcast::model {

/// One place as two views see it; levels, 0 to 255.
struct SharedColor {
  std::size_t view_a = 0, view_b = 0;  // a < b
  Eigen::Vector3f at_m, color_a, color_b;
};

/// At points of the mesh, at most so many of them that a large room takes no longer than a second.
/// A pair of views is left out where one of them sees the surface much worse.
[[nodiscard]] std::vector<SharedColor> shared_colors(std::span<const ViewSurface> views,
                                                     const ModelOptions& options,
                                                     const Workers& workers, const RoomMesh& mesh);

/// Factors on the levels of each view's red, green and blue, kMinGain..kMaxGain; 1 where too little
/// is shared.
inline constexpr float kMinGain = 0.5F, kMaxGain = 2;
[[nodiscard]] std::vector<Eigen::Vector3f> color_gains(std::span<const SharedColor> shared,
                                                       std::size_t view_count);

}  // namespace roomcast::model
