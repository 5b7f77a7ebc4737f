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
  explicit MeshRenderer(GlProgram program);

  GlProgram program_;
  GlVertexArray vertices_;
};

}  // namespace roomcast::render
