// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/room_renderer.h"

#include <string>
#include <utility>

namespace roomcast {

Result<RoomRenderer> RoomRenderer::create() {
  Result<PointRenderer> points = PointRenderer::create();
  if (!points) return std::move(points).error();
  Result<SurfaceMesher> mesher = SurfaceMesher::create();
  if (!mesher) return std::move(mesher).error();
  Result<MeshRenderer> meshes = MeshRenderer::create();
  if (!meshes) return std::move(meshes).error();
  Result<FloorGrid> floor = FloorGrid::create();
  if (!floor) return std::move(floor).error();
  return RoomRenderer(*std::move(points), *std::move(mesher), *std::move(meshes),
                      *std::move(floor));
}

RoomRenderer::RoomRenderer(PointRenderer points, SurfaceMesher mesher, MeshRenderer meshes,
                           FloorGrid floor)
    : points_(std::move(points)),
      mesher_(std::move(mesher)),
      meshes_(std::move(meshes)),
      floor_(std::move(floor)) {}

Status RoomRenderer::set_sensor(SensorId id, const CameraIntrinsics& depth,
                                const RigidTransform& world_from_depth) {
  if (!world_from_depth.rotation.allFinite() || !world_from_depth.translation_m.allFinite()) {
    return Error{ErrorCode::kInvalidArgument, "a sensor's pose must consist of finite numbers"};
  }
  const auto known = sensors_.find(id);
  if (known != sensors_.end() && known->second.surface.intrinsics() == depth) {
    known->second.world_from_depth = world_from_depth;
    return {};
  }
  if (known == sensors_.end() && sensors_.size() >= kMaxRenderedSensors) {
    return Error{ErrorCode::kTooLarge, "no more than 64 sensors can be drawn in one room"};
  }
  Result<SensorSurface> surface = SensorSurface::create(depth);
  if (!surface) return std::move(surface).error();
  sensors_.insert_or_assign(id, Sensor{*std::move(surface), world_from_depth, {}});
  return {};
}
static_assert(kMaxRenderedSensors == 64, "the sentence above says so");

Status RoomRenderer::upload(SensorId id, DepthView depth_mm, ColorView color, MaskView seen) {
  const auto sensor = sensors_.find(id);
  if (sensor == sensors_.end()) {
    return Error{ErrorCode::kNotFound, "sensor " + std::to_string(id.value) +
                                           " has sent a picture before its calibration"};
  }
  return sensor->second.surface.upload(depth_mm, color, seen);
}

void RoomRenderer::remove(SensorId id) {
  sensors_.erase(id);
}

Status RoomRenderer::set_look(const RoomLook& look) {
  Status legal = look.check();
  if (legal) look_ = look;
  return legal;
}

Status RoomRenderer::draw(const ViewCamera& camera, const OffscreenTarget& target,
                          RenderMode mode) {
  if (Status legal = camera.check(); !legal) return legal;
  if (camera.width != target.width() || camera.height != target.height()) {
    return Error{ErrorCode::kInvalidArgument,
                 "the view's size is not that of the picture it is drawn into"};
  }
  target.clear(look_.background);
  if (look_.floor_grid) floor_.draw(camera, look_.floor_line);
  draw_sensors(camera, mode);
  return {};
}

void RoomRenderer::draw_sensors(const ViewCamera& camera, RenderMode mode) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  for (auto& [id, sensor] : sensors_) {
    const SurfaceView view = surface_view(id, sensor.world_from_depth, camera);
    if (mode == RenderMode::kPoints) {
      points_.draw(sensor.surface, view, PointSize::kOnePixel);
    } else if (mode == RenderMode::kSplats) {
      points_.draw(sensor.surface, view, PointSize::kAsSurface);
    } else {
      mesher_.update(sensor.surface, look_.mesh, sensor.mesh);
      meshes_.draw(sensor.surface, sensor.mesh, view);
    }
  }
}

}  // namespace roomcast
