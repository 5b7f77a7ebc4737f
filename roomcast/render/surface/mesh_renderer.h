// SPDX-License-Identifier: Apache-2.0
// MeshRenderer: draws a sensor's surface as the triangles of a SurfaceMesh. Back faces are culled:
// seen from behind, a surface that only one sensor saw would look like a mask turned inside out.
// Draws into the bound framebuffer; needs the GL context it was made with.
#pragma once

#include "roomcast/render/surface/surface_mesh.h"
#include "roomcast/render/view/surface_view.h"

namespace roomcast::render {

class MeshRenderer {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<MeshRenderer> create();

  /// `mesh` must belong to `surface`.
  void draw(const SensorSurface& surface, const SurfaceMesh& mesh, const SurfaceView& view) const;

 private:
  using Program = DrawProgram<
      Vertex<shaders::eyes_glsl, shaders::surface_view_glsl, shaders::sensor_surface_glsl,
             shaders::newest_in_view_glsl, shaders::mesh_vert>,
      Fragment<shaders::mesh_frag>>;

  explicit MeshRenderer(Program program);

  Program program_;
  GlVertexArray vertices_;
};

}  // namespace roomcast::render
