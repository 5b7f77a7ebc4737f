// SPDX-License-Identifier: Apache-2.0
// The exports of roomcast_flow.wasm. README.md in this folder describes their use from JavaScript.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "roomcast/scene_flow/scene_flow.h"

#define ROOMCAST_EXPORT(name) __attribute__((export_name(name)))

namespace {

using namespace roomcast;  // NOLINT: this file is nothing but glue

static_assert(sizeof(scene_flow::CellFlow) == 4 * sizeof(float), "as README.md has them");

constexpr int kMaxSide = 4096;

struct Flow {
  CameraIntrinsics lens;
  std::vector<std::uint16_t> depth_mm;
  scene_flow::SceneFlow flow;
};

}  // namespace

extern "C" {

ROOMCAST_EXPORT("flow_create")
Flow* flow_create(int width, int height, double fx, double fy, double cx, double cy) {
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) return nullptr;
  CameraIntrinsics lens;
  lens.width = width;
  lens.height = height;
  lens.fx = fx;
  lens.fy = fy;
  lens.cx = cx;
  lens.cy = cy;
  std::vector<std::uint16_t> depth_mm(static_cast<std::size_t>(width) *
                                      static_cast<std::size_t>(height));
  Flow flow{lens, std::move(depth_mm), scene_flow::SceneFlow(lens)};
  return std::make_unique<Flow>(std::move(flow)).release();
}

ROOMCAST_EXPORT("flow_destroy") void flow_destroy(Flow* flow) {
  std::unique_ptr<Flow> owned(flow);
}

ROOMCAST_EXPORT("flow_depth") std::uint16_t* flow_depth(Flow* flow) {
  return flow->depth_mm.data();
}

ROOMCAST_EXPORT("flow_take")
const scene_flow::CellFlow* flow_take(Flow* flow, double capture_us) {
  const RoomTime time(nanoseconds(static_cast<std::int64_t>(capture_us * 1000)));
  const CameraIntrinsics& lens = flow->lens;
  flow->flow.take({flow->depth_mm.data(), lens.width, lens.height, lens.width}, time);
  const scene_flow::FlowField* motion = flow->flow.motion();
  return motion == nullptr ? nullptr : motion->data();
}

}  // extern "C"
