// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/surface_flow.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace roomcast::render {

static_assert(sizeof(scene_flow::CellFlow) == 4 * sizeof(float), "cells are uploaded as they are");

SurfaceFlow::SurfaceFlow(const CameraIntrinsics& depth)
    : flow_(depth),
      cells_(make_texture(GL_RGBA16F, flow_.field().width(), flow_.field().height())) {
  clear_cells();
}

void SurfaceFlow::clear_cells() {
  glClearTexImage(cells_.name(), 0, GL_RGBA, GL_FLOAT, nullptr);
}

void SurfaceFlow::take(DepthView depth_mm, std::optional<RoomTime> capture_time) {
  if (std::exchange(time_, capture_time) == capture_time) return;
  if (!capture_time) return clear_cells();
  flow_.take(depth_mm, *capture_time);
  const scene_flow::FlowField& field = flow_.field();
  glTextureSubImage2D(cells_.name(), 0, 0, 0, field.width(), field.height(), GL_RGBA, GL_FLOAT,
                      field.data());
}

float SurfaceFlow::ahead_s(std::optional<RoomTime> instant) const {
  if (!instant || !time_ || flow_.is_still()) return 0;
  const nanoseconds ahead = std::clamp(*instant - *time_, -kMaxAhead, kMaxAhead);
  return std::chrono::duration<float>(ahead).count();
}

}  // namespace roomcast::render
