// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/view/surface_view.h"

namespace roomcast::render {

SurfaceView surface_view(SensorId sensor, const RigidTransform& world_from_depth,
                         const Eyes& eyes) {
  SurfaceView view{sensor, eyes, {}};
  for (std::size_t eye = 0; eye < view.view_from_depth.size(); ++eye) {
    // Multiplied in double: far from the world's origin, surfaces would tremble in single
    // precision.
    view.view_from_depth[eye] =
        matrix_from_transform(eyes[eye].world_from_view.inverse() * world_from_depth);
  }
  return view;
}

void set_surface_view(ProgramWith<shaders::eyes_glsl, shaders::surface_view_glsl> program,
                      const SurfaceView& view) {
  using shaders::surface_view_glsl;
  set_eyes(program, view.eyes);
  program.set(surface_view_glsl::clip_from_view,
              {clip_from_view(view.eyes[0]), clip_from_view(view.eyes[1])});
  program.set(surface_view_glsl::view_from_depth, view.view_from_depth);
  program.set(surface_view_glsl::sensor, GLint{view.sensor.value});
}

Eigen::Matrix4f matrix_from_transform(const RigidTransform& transform) {
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix.topLeftCorner<3, 3>() = transform.rotation.cast<float>();
  matrix.topRightCorner<3, 1>() = transform.translation_m.cast<float>();
  return matrix;
}

}  // namespace roomcast::render
