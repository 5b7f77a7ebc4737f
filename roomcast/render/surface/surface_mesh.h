// SPDX-License-Identifier: Apache-2.0
// SurfaceMesh: the triangles of one sensor's surface: an index buffer over its depth grid, built on
// the GPU once per picture (not per view). Triangles across a break between foreground and
// background are left out. Needs the GL context it was made with.
#pragma once

#include <cstdint>

#include "roomcast/render/surface/sensor_surface.h"

namespace roomcast::render {

struct SurfaceMeshOptions {
  /// A triangle is dropped if the depths of its corners differ by more than this plus a share of
  /// the nearest corner's depth.
  double max_gap_m = 0.012;
  double max_gap_per_m = 0.022;
  /// Depth pixels from one vertex to the next: 2 gives a quarter of the triangles.
  int grid_step = 1;

  /// kInvalidArgument unless the gaps are finite and not negative, and the step is 1..kMaxGridStep.
  [[nodiscard]] Status check() const;
  friend bool operator==(const SurfaceMeshOptions&, const SurfaceMeshOptions&) = default;
};
inline constexpr int kMaxGridStep = 16;

/// GL_TRIANGLES with 32-bit indices, row by row, counter-clockwise as seen from the sensor.
struct SurfaceMesh {
  GlBuffer indices;
  GLsizeiptr capacity = 0;  // in indices
  GLsizei count = 0;        // indices to draw, those of dropped triangles included
  std::uint64_t revision = 0;
  SurfaceMeshOptions options;
};

class SurfaceMesher {
 public:
  /// kUnsupported with the driver's log if it rejects the shader.
  static Result<SurfaceMesher> create();

  /// Rebuilds `mesh` if `surface` or `options` have changed. `options` must be valid.
  void update(const SensorSurface& surface, const SurfaceMeshOptions& options,
              SurfaceMesh& mesh) const;

 private:
  using Program = ComputeProgram<shaders::sensor_surface_glsl, shaders::surface_mesh_comp>;

  explicit SurfaceMesher(Program program) : program_(std::move(program)) {}

  Program program_;
};

}  // namespace roomcast::render
