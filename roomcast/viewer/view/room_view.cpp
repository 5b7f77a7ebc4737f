// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/view/room_view.h"

#include <algorithm>
#include <utility>

#include "roomcast/viewer/view/late_sensors.h"

namespace roomcast::viewer {

Result<RoomView> RoomView::create() {
  auto renderer = render::RoomRenderer::create();
  if (!renderer) return renderer.error();
  auto people = PeopleView::create();
  if (!people) return people.error();
  return RoomView(std::move(*renderer), std::move(*people));
}

// Continues after errors: one sensor that cannot be drawn must not freeze the others.
Status RoomView::show(const client::RoomSnapshot& room, const RoomMotion& motion) {
  Status first_fault;
  people_.follow(room);
  const std::set<SensorId> late = late_sensors(room);
  for (const client::RoomSensor& sensor : room.sensors) {
    auto status = show_sensor(sensor, late.contains(sensor.id), motion);
    if (!status && first_fault) first_fault = std::move(status);
  }
  return first_fault;
}

// Does not draw a sensor that is offline or has not sent anything: an old picture would look live.
Status RoomView::show_sensor(const client::RoomSensor& sensor, bool is_late,
                             const RoomMotion& motion) {
  if (!sensor.online || !sensor.picture || hidden_.contains(sensor.id)) {
    renderer_.remove(sensor.id);
    uploaded_.erase(sensor.id);
    return {};
  }
  if (auto status =
          renderer_.set_sensor(sensor.id, sensor.calibration.depth, sensor.pose.world_from_depth);
      !status) {
    return status;
  }
  renderer_.set_unplaced(sensor.id, !sensor.pose.is_placed());
  renderer_.set_late(sensor.id, is_late);
  Uploaded& uploaded = uploaded_[sensor.id];
  if (sensor.is_paused) return clear_surface(sensor, uploaded);
  if (uploaded.picture == sensor.picture && uploaded.lens == sensor.calibration.depth) return {};
  const codec::DecodedFrame& frame = sensor.picture->frame;
  const auto moves = motion.find(sensor.id);
  if (auto status = renderer_.upload(
          sensor.id, frame.depth_mm, frame.color, frame.color_seen,
          {sensor.picture->capture_time, moves != motion.end() ? moves->second.get() : nullptr});
      !status)
    return status;
  uploaded = {sensor.picture, sensor.calibration.depth};
  return {};
}

/// What moves would stay where it was. The background that the sensor has seen stays.
Status RoomView::clear_surface(const client::RoomSensor& sensor, Uploaded& uploaded) {
  const CameraIntrinsics& lens = sensor.calibration.depth;
  if (uploaded.is_cleared && uploaded.lens == lens) return {};
  const DepthImage no_depth(lens.width, lens.height);
  const ColorImage no_color(lens.width, lens.height);
  const MaskImage none_seen(lens.width, lens.height);
  if (auto status = renderer_.upload(sensor.id, no_depth, no_color, none_seen); !status)
    return status;
  uploaded = {nullptr, lens, true};
  return {};
}

Status RoomView::take_model(const model::DecodedModel& news) {
  if (news.is_whole) renderer_.clear_model();
  Status first_fault;
  for (const auto& [place, mesh] : news.pieces) {
    auto status = renderer_.set_model_piece({place.x, place.y, place.z},
                                            {mesh.points_m, mesh.colors, mesh.triangles});
    if (!status && first_fault) first_fault = std::move(status);
  }
  return first_fault;
}

Status RoomView::draw(const render::Eyes& eyes, const render::OffscreenTarget& target,
                      render::RenderMode mode) {
  if (auto status = renderer_.draw(eyes, target, mode); !status) return status;
  people_.draw(eyes, target);
  return {};
}

RigidTransform world_from_start_view(const client::RoomSnapshot& room) {
  return room.start_pose.value_or(render::world_from_view_looking_at({0, 1.6, 0}, {0, 1.2, -1}));
}

}  // namespace roomcast::viewer
