// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/surface_flow.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "roomcast/core/assert.h"

namespace roomcast::render {
namespace {

void set_to_zero(const GlTexture& texture) {
  glClearTexImage(texture.name(), 0, GL_RGBA, GL_FLOAT, nullptr);
}

}  // namespace

static_assert(sizeof(scene_flow::CellFlow) == 4 * sizeof(float), "cells are uploaded as they are");

SurfaceFlow::SurfaceFlow(const CameraIntrinsics& depth)
    : width_(depth.width),
      height_(depth.height),
      cells_(make_texture(GL_RGBA16F, scene_flow::cells_along(depth.width),
                          scene_flow::cells_along(depth.height))),
      velocities_(make_texture(GL_RGBA16F, depth.width, depth.height)) {
  set_to_zero(velocities_);
}

void SurfaceFlow::take(const PictureMotion& motion) {
  time_ = motion.capture_time;
  moves_ = time_ && motion.cells != nullptr;
  if (!moves_) return;
  const scene_flow::FlowField& cells = *motion.cells;
  ROOMCAST_ASSERT(cells.width() == scene_flow::cells_along(width_) &&
                  cells.height() == scene_flow::cells_along(height_));
  glTextureSubImage2D(cells_.name(), 0, 0, 0, cells.width(), cells.height(), GL_RGBA, GL_FLOAT,
                      cells.data());
}

void SurfaceFlow::interpolate(const FlowInterpolation& program, const GlTexture& depth_m) {
  const bool were_zero = std::exchange(velocities_are_zero_, !moves_);
  if (!moves_) {
    if (!were_zero) set_to_zero(velocities_);
    return;
  }
  using shaders::interpolate_flow_comp;
  program.bind(interpolate_flow_comp::cells, cells_);
  program.bind(interpolate_flow_comp::depth_m, depth_m);
  program.bind(interpolate_flow_comp::velocities_out, velocities_);
  program.run(width_, height_);
}

float SurfaceFlow::ahead_s(std::optional<RoomTime> instant) const {
  if (!instant || !moves_) return 0;
  const nanoseconds ahead = std::clamp(*instant - *time_, -kMaxAhead, kMaxAhead);
  return std::chrono::duration<float>(ahead).count();
}

}  // namespace roomcast::render
