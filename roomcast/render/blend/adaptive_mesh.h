// SPDX-License-Identifier: Apache-2.0
// A surface as few triangles: large ones where it is flat, small ones where it is not, none where
// it breaks. Built on the GPU once per picture; how many there are the CPU never learns. Where
// triangles of different sizes meet, gaps of the surface's noise can open. Needs the GL context it
// was made with.
#pragma once

#include "roomcast/core/result.h"
#include "roomcast/render/gl/gl_program.h"
#include "roomcast/render/surface/surface_mesh.h"
#include "roomcast/render/view/eyes.h"

namespace roomcast::render {

struct AdaptiveMesh {
  GlBuffer indices;  // GL_TRIANGLES, 32 bits, counter-clockwise as the sensor sees them
  static constexpr GLsizeiptr kCommandBytes = 5 * sizeof(GLuint);
  GlBuffer commands;  // for glDrawElementsIndirect: for one eye, for two
};

class AdaptiveMesher {
 public:
  /// kUnsupported with the driver's log when it does not take the shaders.
  static Result<AdaptiveMesher> create();

  /// Of a depth texture in metres. `covering`: another surface in the same grid; what lies on it is
  /// left out. Null: nothing is. `options.grid_step` counts for nothing here.
  void build(const GlTexture& depth_m, const GlTexture* covering, int width, int height,
             const SurfaceMeshOptions& options, AdaptiveMesh& mesh);

 private:
  AdaptiveMesher(GlProgram tiles, GlProgram offsets, GlProgram gather);
  void make_room(int tiles);

  GlProgram tiles_program_, offsets_program_, gather_program_;
  int tiles_ = 0;  // that the buffers hold
  GlBuffer tile_indices_, tile_counts_, tile_offsets_;
};

}  // namespace roomcast::render
