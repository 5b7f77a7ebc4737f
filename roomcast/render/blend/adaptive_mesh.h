// SPDX-License-Identifier: Apache-2.0
// AdaptiveMesh: a surface as few triangles: large where it is flat, small elsewhere, none at
// breaks. Built on the GPU once per picture; the triangle count stays on the GPU. Gaps as wide as
// the surface's noise can appear between triangles of different sizes. Needs the GL context it was
// made with.
#pragma once

#include <utility>

#include "roomcast/core/result.h"
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

  /// Another surface in the same grid: parts that coincide with it are left out.
  struct Covering {
    const GlTexture* depth_m = nullptr;  // metres, 0 where there is no such surface
    /// Only parts wholly before such a surface are kept, so that noise leaves no specks, and, where
    /// there is no such surface, parts that move.
    bool is_needed = false;
    const GlTexture* velocities = nullptr;  // SurfaceFlow::velocities, if it is needed
  };

  /// Meshes a depth texture in metres. `options.grid_step` is ignored.
  void build(const GlTexture& depth_m, const Covering& covering, int width, int height,
             const SurfaceMeshOptions& options, AdaptiveMesh& mesh);

 private:
  struct Programs {
    ComputeProgram<shaders::depth_noise_glsl, shaders::blend_surface_glsl,
                   shaders::adaptive_mesh_comp>
        tiles;
    ComputeProgram<shaders::mesh_offsets_comp> offsets;
    ComputeProgram<shaders::mesh_gather_comp> gather;
  };
  explicit AdaptiveMesher(Programs programs) : programs_(std::move(programs)) {}
  void make_room(int tiles);

  Programs programs_;
  int tiles_ = 0;  // capacity of the buffers
  GlBuffer tile_indices_, tile_counts_, tile_offsets_;
};

}  // namespace roomcast::render
