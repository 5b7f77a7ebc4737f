// SPDX-License-Identifier: Apache-2.0
// The triangles of one sensor's surface: an index buffer over its depth grid, built on the GPU once
// per picture (not per view), without the triangles that would span a break between foreground and
// background. Needs the GL context it was made with.
#pragma once

#include <cstdint>

#include "roomcast/render/gl/gl_program.h"
#include "roomcast/render/surface/sensor_surface.h"

namespace roomcast::render {

struct SurfaceMeshOptions {
  /// A triangle is dropped when its corners lie further apart in depth than this plus a share of
  /// the nearest one's.
  double max_gap_m = 0.012;
  double max_gap_per_m = 0.022;
  /// Every how many depth pixels a vertex lies: 2 is four times fewer triangles.
  int grid_step = 1;

  /// kInvalidArgument unless the gaps are finite and not negative, and the step is 1..kMaxGridStep.
  [[nodiscard]] Status check() const;
  friend bool operator==(const SurfaceMeshOptions&, const SurfaceMeshOptions&) = default;
};
inline constexpr int kMaxGridStep = 16;

/// The triangles; GL_TRIANGLES, 32-bit indices row by row, counter-clockwise as the sensor sees
/// them.
struct SurfaceMesh {
  GlBuffer indices;
  GLsizeiptr capacity = 0;  // indices that the buffer holds
  GLsizei count = 0;        // indices to draw, those of dropped triangles included
  std::uint64_t revision = 0;
  SurfaceMeshOptions options;
};

class SurfaceMesher {
 public:
  /// kUnsupported with the driver's log when it does not take the shader.
  static Result<SurfaceMesher> create();

  /// Brings `mesh` up to date with `surface`; nothing to do when it is. `options` must be legal.
  void update(const SensorSurface& surface, const SurfaceMeshOptions& options,
              SurfaceMesh& mesh) const;

 private:
  explicit SurfaceMesher(GlProgram program) : program_(std::move(program)) {}

  GlProgram program_;
};

}  // namespace roomcast::render
