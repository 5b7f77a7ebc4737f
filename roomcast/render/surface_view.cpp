// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/surface_view.h"

namespace roomcast {
namespace {

// As in shaders/.
enum UniformLocation : GLint { kClipFromView = 0, kViewFromDepth = 1, kSensor = 3 };

}  // namespace

SurfaceView surface_view(SensorId sensor, const RigidTransform& world_from_depth,
                         const ViewCamera& camera) {
  // Multiplied in double: far from the world's origin, single precision would make surfaces
  // tremble.
  const RigidTransform view_from_depth = camera.world_from_view.inverse() * world_from_depth;
  return {sensor, clip_from_view(camera), matrix_from_transform(view_from_depth),
          focal_length_px(camera)};
}

void set_surface_view(const GlProgram& program, const SurfaceView& view) {
  glProgramUniformMatrix4fv(program.name(), kClipFromView, 1, GL_FALSE, view.clip_from_view.data());
  glProgramUniformMatrix4fv(program.name(), kViewFromDepth, 1, GL_FALSE,
                            view.view_from_depth.data());
  glProgramUniform1i(program.name(), kSensor, view.sensor.value);
}

Eigen::Matrix4f matrix_from_transform(const RigidTransform& transform) {
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix.topLeftCorner<3, 3>() = transform.rotation.cast<float>();
  matrix.topRightCorner<3, 1>() = transform.translation_m.cast<float>();
  return matrix;
}

}  // namespace roomcast
