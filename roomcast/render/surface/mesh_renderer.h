// SPDX-License-Identifier: Apache-2.0
// Draws a sensor's surface as the triangles of a SurfaceMesh. Back faces are not drawn: from
// behind, a surface that only one sensor saw is open, and not a mask turned inside out. Draws into
// the bound framebuffer; needs the GL context it was made with.
#pragma once

#include "roomcast/render/surface/surface_mesh.h"
#include "roomcast/render/view/surface_view.h"

namespace roomcast::render {

class MeshRenderer {
 public:
  /// kUnsupported with the driver's log when it does not take the shaders.
  static Result<MeshRenderer> create();

  /// `mesh` must be that of `surface`.
  void draw(const SensorSurface& surface, const SurfaceMesh& mesh, const SurfaceView& view) const;

 private:
  explicit MeshRenderer(GlProgram program);

  GlProgram program_;
  GlVertexArray vertices_;
};

}  // namespace roomcast::render
