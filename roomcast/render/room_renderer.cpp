// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/room_renderer.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace roomcast::render {

Result<RoomRenderer> RoomRenderer::create() {
  auto parts = create_parts(&Parts::points, &Parts::mesher, &Parts::meshes, &Parts::floor,
                            &Parts::updater, &Parts::adaptive, &Parts::blend, &Parts::model);
  if (!parts) return std::move(parts).error();
  return RoomRenderer(*std::move(parts));
}

Status RoomRenderer::set_sensor(SensorId id, const CameraIntrinsics& depth,
                                const RigidTransform& world_from_depth) {
  if (!world_from_depth.rotation.allFinite() || !world_from_depth.translation_m.allFinite()) {
    return Error{ErrorCode::kInvalidArgument, "a sensor's pose must consist of finite numbers"};
  }
  const auto known = sensors_.find(id);
  if (known != sensors_.end() && known->second.surface.intrinsics() == depth) {
    RigidTransform& pose = known->second.world_from_depth;
    if (pose == world_from_depth) return {};
    pose = world_from_depth;
    for (auto& [other, sensor] : sensors_) sensor.model_is_fresh = false;
    return {};
  }
  if (known == sensors_.end() && sensors_.size() >= kMaxRenderedSensors) {
    return Error{ErrorCode::kTooLarge, "no more than 64 sensors can be drawn in one room"};
  }
  Result<SensorSurface> surface = SensorSurface::create(depth);
  if (!surface) return std::move(surface).error();
  sensors_.insert_or_assign(
      id,
      Sensor{
          *std::move(surface), world_from_depth, {}, BackgroundModel(depth), SurfaceFlow(depth)});
  return {};
}
static_assert(kMaxRenderedSensors == 64, "the sentence above says so");

void RoomRenderer::set_unplaced(SensorId id, bool unplaced) {
  const auto known = sensors_.find(id);
  if (known == sensors_.end()) return;
  if (std::exchange(known->second.is_unplaced, unplaced) == unplaced) return;
  for (auto& [other, sensor] : sensors_) sensor.model_is_fresh = false;
}

void RoomRenderer::set_late(SensorId id, bool late) {
  const auto known = sensors_.find(id);
  if (known == sensors_.end()) return;
  if (std::exchange(known->second.is_late, late) != late) known->second.model_is_fresh = false;
}

Status RoomRenderer::upload(SensorId id, DepthView depth_mm, ColorView color, MaskView seen,
                            const PictureMotion& motion) {
  const auto sensor = sensors_.find(id);
  if (sensor == sensors_.end()) {
    return Error{ErrorCode::kNotFound, "sensor " + std::to_string(id.value) +
                                           " has sent a picture before its calibration"};
  }
  Sensor& known = sensor->second;
  if (Status uploaded = known.surface.upload(depth_mm, color, seen); !uploaded) return uploaded;
  known.flow.take(motion);
  if (options_.update_background) {
    parts_.updater.update(known.surface, known.background_model);
    colors_.offer(id, known.surface.intrinsics(), depth_mm, color, seen);
  }
  known.model_is_fresh = false;
  for (auto& [other, late] : sensors_) {
    if (late.is_late) late.model_is_fresh = false;
  }
  return {};
}

void RoomRenderer::remove(SensorId id) {
  sensors_.erase(id);
  colors_.forget(id);
}

Status RoomRenderer::set_options(const RenderOptions& options) {
  Status legal = options.check();
  if (legal) options_ = options;
  return legal;
}

Status RoomRenderer::draw(const Eyes& eyes, const OffscreenTarget& target, RenderMode mode) {
  if (Status legal = eyes.check(); !legal) return legal;
  if (eyes.width() != target.width() || eyes.height() != target.height() ||
      eyes.count() != target.eyes()) {
    return Error{ErrorCode::kInvalidArgument,
                 "the view's size is not that of the picture it is drawn into"};
  }
  if (options_.background_is_clear) {
    target.clear({}, 0);
  } else {
    target.clear(options_.background);
  }
  if (options_.floor_grid) parts_.floor.draw(eyes, options_.floor_line);
  if (mode == RenderMode::kStill) {
    parts_.blend.draw({}, parts_.model, eyes, options_.unseen, target);
    return {};
  }
  if (!uses_background_model(mode)) {
    draw_sensors(eyes, mode);
    return {};
  }
  refresh_background_models();
  gather_layers(mode);
  if (mode == RenderMode::kBlend) {
    parts_.blend.draw(layers_, parts_.model, eyes, options_.unseen, target);
  } else {
    parts_.adaptive.draw(layers_, eyes, target);
  }
  draw_unplaced(eyes);
  return {};
}

/// Sensors that cannot be brought to it with the newest do not count.
std::optional<RoomTime> RoomRenderer::shown_instant() const {
  if (instant_) return instant_;
  std::optional<RoomTime> newest;
  for (const auto& [id, sensor] : sensors_) {
    if (!sensor.is_unplaced) newest = std::max(newest, sensor.flow.time());
  }
  if (!newest) return std::nullopt;
  RoomTime oldest = *newest;
  for (const auto& [id, sensor] : sensors_) {
    const std::optional<RoomTime> time = sensor.flow.time();
    if (time && !sensor.is_unplaced && *newest - *time <= 2 * kMaxAhead) {
      oldest = std::min(oldest, *time);
    }
  }
  return oldest + (*newest - oldest) / 2;
}

/// Puts live surfaces before backs and backgrounds, which they mostly hide; only blend mode draws
/// those.
void RoomRenderer::gather_layers(RenderMode mode) {
  using Part = SurfaceLayer::Part;
  const std::optional<RoomTime> instant = shown_instant();
  layers_.clear();
  const auto gather = [&](Part part) {
    for (const auto& [id, sensor] : sensors_) {
      if (sensor.is_unplaced) continue;
      const BackgroundModel& model = sensor.background_model;
      layers_.push_back({id, sensor.world_from_depth,
                         part == Part::kBackground ? &model.background() : &model.live(),
                         &sensor.surface.rays(), &sensor.flow, part,
                         part == Part::kBackground ? 0 : sensor.flow.ahead_s(instant)});
    }
  };
  gather(Part::kLive);
  if (mode != RenderMode::kBlend) return;
  gather(Part::kBacks);
  gather(Part::kBackground);
}

void RoomRenderer::refresh_background_models() {
  const auto is_fresh = [](const auto& sensor) {
    return sensor.second.model_is_fresh || sensor.second.is_unplaced;
  };
  if (std::ranges::all_of(sensors_, is_fresh)) return;
  std::map<SensorId, RigidTransform> poses;
  for (const auto& [id, sensor] : sensors_) {
    if (!sensor.is_unplaced) poses.emplace(id, sensor.world_from_depth);
  }
  colors_.update(poses);
  for (auto& [id, sensor] : sensors_) {
    if (sensor.is_unplaced || std::exchange(sensor.model_is_fresh, true)) continue;
    std::vector<OtherSensor> others;
    for (const auto& [other_id, other] : sensors_) {
      if (other_id == id || other.is_unplaced) continue;
      others.push_back({&other.surface, other.world_from_depth.inverse() * sensor.world_from_depth,
                        other.is_late});
    }
    parts_.updater.refresh(sensor.surface, others,
                           {options_.mesh, colors_.gain(id), sensor.is_late, sensor.flow},
                           sensor.background_model);
  }
}

void RoomRenderer::draw_sensors(const Eyes& eyes, RenderMode mode) {
  const EyeBorders borders(eyes);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  for (auto& [id, sensor] : sensors_) draw_sensor(id, sensor, eyes, mode);
}

/// Draws unplaced sensors after the other surfaces, against the depth those have left.
void RoomRenderer::draw_unplaced(const Eyes& eyes) {
  const EyeBorders borders(eyes);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  for (auto& [id, sensor] : sensors_) {
    if (sensor.is_unplaced) draw_sensor(id, sensor, eyes, RenderMode::kMesh);
  }
}

void RoomRenderer::draw_sensor(SensorId id, Sensor& sensor, const Eyes& eyes, RenderMode mode) {
  const SurfaceView view = surface_view(id, sensor.world_from_depth, eyes);
  if (mode == RenderMode::kPoints) {
    parts_.points.draw(sensor.surface, view, PointSize::kOnePixel);
  } else if (mode == RenderMode::kSplats) {
    parts_.points.draw(sensor.surface, view, PointSize::kAsSurface);
  } else {
    parts_.mesher.update(sensor.surface, options_.mesh, sensor.mesh);
    parts_.meshes.draw(sensor.surface, sensor.mesh, view);
  }
}

}  // namespace roomcast::render
