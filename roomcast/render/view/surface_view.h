// SPDX-License-Identifier: Apache-2.0
// SurfaceView: one sensor's surface as seen from one or two eyes: the uniforms of the point and
// mesh shaders.
#pragma once

#include <Eigen/Core>

#include "roomcast/core/ids.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/render/gl/shaders.h"
#include "roomcast/render/view/eyes.h"

namespace roomcast::render {

struct SurfaceView {
  SensorId sensor;
  Eyes eyes;
  EyeMatrices view_from_depth;
};

[[nodiscard]] SurfaceView surface_view(SensorId sensor, const RigidTransform& world_from_depth,
                                       const Eyes& eyes);

/// Sets the uniforms that all surface shaders share.
void set_surface_view(ProgramWith<shaders::eyes_glsl, shaders::surface_view_glsl> program,
                      const SurfaceView& view);

/// The transform as a 4x4 matrix for OpenGL.
[[nodiscard]] Eigen::Matrix4f matrix_from_transform(const RigidTransform& transform);

}  // namespace roomcast::render
