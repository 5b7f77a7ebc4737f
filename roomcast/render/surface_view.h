// SPDX-License-Identifier: Apache-2.0
// How one sensor's surface is seen from one eye: what the point and the mesh shaders need besides
// the pictures.
#pragma once

#include <Eigen/Core>

#include "roomcast/core/ids.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/render/gl_program.h"
#include "roomcast/render/view_camera.h"

namespace roomcast {

struct SurfaceView {
  SensorId sensor;
  Eigen::Matrix4f clip_from_view;
  Eigen::Matrix4f view_from_depth;
  double focal_px = 0;  // of the eye
};

[[nodiscard]] SurfaceView surface_view(SensorId sensor, const RigidTransform& world_from_depth,
                                       const ViewCamera& camera);

/// Fills the uniforms that all surface shaders share (shaders/sensor_surface.glsl, `sensor`).
void set_surface_view(const GlProgram& program, const SurfaceView& view);

/// The OpenGL matrix of a transform.
[[nodiscard]] Eigen::Matrix4f matrix_from_transform(const RigidTransform& transform);

}  // namespace roomcast
