// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/surface_flow.h"

#include <algorithm>
#include <chrono>
#include <utility>

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
      flow_(depth),
      cells_(make_texture(GL_RGBA16F, flow_.field().width(), flow_.field().height())),
      velocities_(make_texture(GL_RGBA16F, depth.width, depth.height)) {
  set_to_zero(velocities_);
}

void SurfaceFlow::take(DepthView depth_mm, std::optional<RoomTime> capture_time) {
  if (std::exchange(time_, capture_time) == capture_time || !capture_time) return;
  flow_.take(depth_mm, *capture_time);
  if (flow_.is_still()) return;
  const scene_flow::FlowField& field = flow_.field();
  glTextureSubImage2D(cells_.name(), 0, 0, 0, field.width(), field.height(), GL_RGBA, GL_FLOAT,
                      field.data());
}

void SurfaceFlow::interpolate(const FlowInterpolation& program, const GlTexture& depth_m) {
  const bool were_zero = std::exchange(velocities_are_zero_, !moves());
  if (!moves()) {
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
  if (!instant || !moves()) return 0;
  const nanoseconds ahead = std::clamp(*instant - *time_, -kMaxAhead, kMaxAhead);
  return std::chrono::duration<float>(ahead).count();
}

}  // namespace roomcast::render
