// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/surface/surface_mesh.h"

#include <cmath>

#include "roomcast/core/assert.h"

namespace roomcast::render {
namespace {

constexpr int kIndicesPerCell = 6;

bool legal_gap(double gap) {
  return gap >= 0 && std::isfinite(gap);
}

bool up_to_date(const SurfaceMesh& mesh, const SensorSurface& surface,
                const SurfaceMeshOptions& options) {
  return mesh.indices.name() != 0 && mesh.revision == surface.revision() && mesh.options == options;
}

void reserve(SurfaceMesh& mesh, GLsizei count) {
  mesh.count = count;
  if (count <= mesh.capacity) return;
  mesh.indices = make_buffer(static_cast<GLsizeiptr>(count) * sizeof(GLuint));
  mesh.capacity = count;
}

}  // namespace

Status SurfaceMeshOptions::check() const {
  if (!legal_gap(max_gap_m) || !legal_gap(max_gap_per_m)) {
    return Error{ErrorCode::kInvalidArgument,
                 "a mesh's largest gap must be finite and not negative"};
  }
  if (grid_step < 1 || grid_step > kMaxGridStep) {
    return Error{ErrorCode::kInvalidArgument, "a mesh's grid step must be 1 to 16 depth pixels"};
  }
  return {};
}
static_assert(kMaxGridStep == 16, "the sentence above says so");

Result<SurfaceMesher> SurfaceMesher::create() {
  Result<Program> program = Program::create();
  if (!program) return std::move(program).error();
  return SurfaceMesher(*std::move(program));
}

void SurfaceMesher::update(const SensorSurface& surface, const SurfaceMeshOptions& options,
                           SurfaceMesh& mesh) const {
  ROOMCAST_ASSERT(options.check().ok());
  if (up_to_date(mesh, surface, options)) return;
  const int cells_x = (surface.intrinsics().width - 1) / options.grid_step;
  const int cells_y = (surface.intrinsics().height - 1) / options.grid_step;
  reserve(mesh, cells_x * cells_y * kIndicesPerCell);
  mesh.revision = surface.revision();
  mesh.options = options;
  if (mesh.count == 0) return;

  using shaders::surface_mesh_comp;
  program_.set(surface_mesh_comp::grid_step, options.grid_step);
  program_.set(surface_mesh_comp::cells, {cells_x, cells_y});
  program_.set(surface_mesh_comp::max_gap,
               {static_cast<float>(options.max_gap_m), static_cast<float>(options.max_gap_per_m)});
  surface.bind_to(program_);
  program_.bind(surface_mesh_comp::Indices, mesh.indices);
  program_.run(cells_x, cells_y, 1, GL_ELEMENT_ARRAY_BARRIER_BIT);
}

}  // namespace roomcast::render
