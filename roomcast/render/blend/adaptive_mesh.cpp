// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/adaptive_mesh.h"

#include <utility>

#include "roomcast/render/gl/shader_sources.h"

namespace roomcast::render {
namespace {

// As in shaders/blend/.
constexpr int kTileSide = 16;
constexpr GLsizeiptr kMaxIndicesOfTile = 6 * kTileSide * kTileSide;
enum TextureUnit : GLuint { kDepth = 0, kCovering = 5 };
enum TilesUniform : GLint { kMaxGap = 4, kIsCovered = 5 };
constexpr GLint kTileCount = 0;  // uniform of mesh_offsets.comp
constexpr GLsizeiptr kIndexBytes = sizeof(GLuint);

void bind_buffer(GLuint binding, const GlBuffer& buffer) {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.name());
}

void dispatch(const GlProgram& program, int across, int down) {
  glUseProgram(program.name());
  glDispatchCompute(static_cast<GLuint>(across), static_cast<GLuint>(down), 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace

Result<AdaptiveMesher> AdaptiveMesher::create() {
  auto tiles = make_program(
      {{GL_COMPUTE_SHADER,
        {shaders::depth_noise_glsl, shaders::blend_surface_glsl, shaders::adaptive_mesh_comp}}});
  if (!tiles) return std::move(tiles).error();
  auto offsets = make_program({{GL_COMPUTE_SHADER, {shaders::mesh_offsets_comp}}});
  if (!offsets) return std::move(offsets).error();
  auto gather = make_program({{GL_COMPUTE_SHADER, {shaders::mesh_gather_comp}}});
  if (!gather) return std::move(gather).error();
  return AdaptiveMesher(*std::move(tiles), *std::move(offsets), *std::move(gather));
}

AdaptiveMesher::AdaptiveMesher(GlProgram tiles, GlProgram offsets, GlProgram gather)
    : tiles_program_(std::move(tiles)),
      offsets_program_(std::move(offsets)),
      gather_program_(std::move(gather)) {}

void AdaptiveMesher::make_room(int tiles) {
  if (tiles <= tiles_) return;
  tiles_ = tiles;
  tile_indices_ = make_buffer(tiles * kMaxIndicesOfTile * kIndexBytes);
  tile_counts_ = make_buffer(tiles * kIndexBytes);
  tile_offsets_ = make_buffer(tiles * kIndexBytes);
}

void AdaptiveMesher::build(const GlTexture& depth_m, const GlTexture* covering, int width,
                           int height, const SurfaceMeshOptions& options, AdaptiveMesh& mesh) {
  const int across = (width + kTileSide - 1) / kTileSide;
  const int down = (height + kTileSide - 1) / kTileSide;
  make_room(across * down);
  if (mesh.indices.name() == 0) {
    mesh.indices = make_buffer(across * down * kMaxIndicesOfTile * kIndexBytes);
    mesh.commands = make_buffer(kMaxEyes * AdaptiveMesh::kCommandBytes);
  }
  glBindTextureUnit(kDepth, depth_m.name());
  glBindTextureUnit(kCovering, covering != nullptr ? covering->name() : depth_m.name());
  glProgramUniform1i(tiles_program_.name(), kIsCovered, covering != nullptr);
  glProgramUniform2f(tiles_program_.name(), kMaxGap, static_cast<float>(options.max_gap_m),
                     static_cast<float>(options.max_gap_per_m));
  bind_buffer(0, tile_indices_);
  bind_buffer(1, tile_counts_);
  dispatch(tiles_program_, across, down);

  glProgramUniform1ui(offsets_program_.name(), kTileCount, static_cast<GLuint>(across * down));
  bind_buffer(2, tile_offsets_);
  bind_buffer(3, mesh.commands);
  dispatch(offsets_program_, 1, 1);

  bind_buffer(3, mesh.indices);
  dispatch(gather_program_, across * down, 1);
  glMemoryBarrier(GL_ELEMENT_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

}  // namespace roomcast::render
