// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/adaptive_mesh.h"

#include <utility>

namespace roomcast::render {
namespace {

using shaders::adaptive_mesh_comp;
using shaders::mesh_gather_comp;
using shaders::mesh_offsets_comp;

constexpr int kTileSide = adaptive_mesh_comp::local_size[0];
constexpr GLsizeiptr kMaxIndicesOfTile = 6 * kTileSide * kTileSide;
constexpr GLsizeiptr kIndexBytes = sizeof(GLuint);

}  // namespace

Result<AdaptiveMesher> AdaptiveMesher::create() {
  auto programs = create_parts(&Programs::tiles, &Programs::offsets, &Programs::gather);
  if (!programs) return std::move(programs).error();
  return AdaptiveMesher(*std::move(programs));
}

void AdaptiveMesher::make_room(int tiles) {
  if (tiles <= tiles_) return;
  tiles_ = tiles;
  tile_indices_ = make_buffer(tiles * kMaxIndicesOfTile * kIndexBytes);
  tile_counts_ = make_buffer(tiles * kIndexBytes);
  tile_offsets_ = make_buffer(tiles * kIndexBytes);
}

void AdaptiveMesher::build(const GlTexture& depth_m, const Covering& covering, int width,
                           int height, const SurfaceMeshOptions& options, AdaptiveMesh& mesh) {
  const int across = (width + kTileSide - 1) / kTileSide;
  const int down = (height + kTileSide - 1) / kTileSide;
  make_room(across * down);
  if (mesh.indices.name() == 0) {
    mesh.indices = make_buffer(across * down * kMaxIndicesOfTile * kIndexBytes);
    mesh.commands = make_buffer(kMaxEyes * AdaptiveMesh::kCommandBytes);
  }
  const auto& [tiles, offsets, gather] = programs_;
  tiles.bind(shaders::blend_surface_glsl::depth_m, depth_m);
  tiles.bind(adaptive_mesh_comp::covering_depth_m,
             covering.depth_m != nullptr ? *covering.depth_m : depth_m);
  tiles.bind(adaptive_mesh_comp::velocities,
             covering.velocities != nullptr ? *covering.velocities : depth_m);
  tiles.set(adaptive_mesh_comp::is_covered, covering.depth_m != nullptr);
  tiles.set(adaptive_mesh_comp::needs_covering, covering.is_needed);
  tiles.set(adaptive_mesh_comp::max_gap,
            {static_cast<float>(options.max_gap_m), static_cast<float>(options.max_gap_per_m)});
  tiles.bind(adaptive_mesh_comp::Tiles, tile_indices_);
  tiles.bind(adaptive_mesh_comp::Counts, tile_counts_);
  tiles.run(width, height, 1, GL_SHADER_STORAGE_BARRIER_BIT);

  offsets.set(mesh_offsets_comp::tiles, static_cast<GLuint>(across * down));
  offsets.bind(mesh_offsets_comp::Counts, tile_counts_);
  offsets.bind(mesh_offsets_comp::Offsets, tile_offsets_);
  offsets.bind(mesh_offsets_comp::Commands, mesh.commands);
  offsets.run(offsets.kGroupSize[0], 1, 1, GL_SHADER_STORAGE_BARRIER_BIT);

  gather.bind(mesh_gather_comp::Tiles, tile_indices_);
  gather.bind(mesh_gather_comp::Counts, tile_counts_);
  gather.bind(mesh_gather_comp::Offsets, tile_offsets_);
  gather.bind(mesh_gather_comp::Indices, mesh.indices);
  gather.run(across * down * gather.kGroupSize[0], 1, 1,  // one group per tile
             GL_ELEMENT_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace roomcast::render
