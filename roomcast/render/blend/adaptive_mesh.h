// SPDX-License-Identifier: Apache-2.0
// AdaptiveMesh: a surface as few triangles: large where it is flat, small elsewhere, none at
// breaks. Built on the GPU once per picture; the triangle count stays on the GPU. Gaps as wide as
// the surface's noise can appear between triangles of different sizes. Needs the GL context it was
// made with.
#pragma once

#include "roomcast/core/result.h"
#include "roomcast/render/gl/gl_program.h"
#include "roomcast/render/surface/surface_mesh.h"
#include "roomcast/render/view/eyes.h"

namespace roomcast::render {

struct AdaptiveMesh {
  GlBuffer indices;  // GL_TRIANGLES, 32 bits, counter-clockwise as seen from the sensor
  static constexpr GLsizeiptr kCommandBytes = 5 * sizeof(GLuint);
  GlBuffer commands;  // for glDrawElementsIndirect: one for one eye, one for two
};

class AdaptiveMesher {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<AdaptiveMesher> create();

  /// Meshes a depth texture in metres. `covering`: another surface in the same grid, or null; parts
  /// that coincide with it are left out. `options.grid_step` is ignored.
  void build(const GlTexture& depth_m, const GlTexture* covering, int width, int height,
             const SurfaceMeshOptions& options, AdaptiveMesh& mesh);

 private:
  AdaptiveMesher(GlProgram tiles, GlProgram offsets, GlProgram gather);
  void make_room(int tiles);

  GlProgram tiles_program_, offsets_program_, gather_program_;
  int tiles_ = 0;  // capacity of the buffers
  GlBuffer tile_indices_, tile_counts_, tile_offsets_;
};

}  // namespace roomcast::render
