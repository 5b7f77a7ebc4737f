// SPDX-License-Identifier: Apache-2.0
// RoomView: draws the room that a Subscriber receives, and the people in it. Keeps the renderer in
// step with the snapshots and uploads only pictures that are new. Threading: the thread of its GL
// context.
#pragma once

#include <memory>
#include <set>
#include <unordered_map>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/core/result.h"
#include "roomcast/render/room_renderer.h"
#include "roomcast/render/view/eyes.h"
#include "roomcast/render/view/offscreen_target.h"
#include "roomcast/viewer/people/people_view.h"

namespace roomcast::viewer {

class RoomView {
 public:
  /// Needs a current GL context. Errors as RoomRenderer::create.
  static Result<RoomView> create();

  /// From now on this is what is drawn. Errors as RoomRenderer::set_sensor and upload; the other
  /// sensors are drawn all the same.
  Status show(const client::RoomSnapshot& room);

  /// Sensors that are not to be drawn, from the next show() on.
  void hide(std::set<SensorId> sensors) { hidden_ = std::move(sensors); }
  /// Errors as RoomRenderer::set_look.
  Status set_look(const render::RenderOptions& look) { return renderer_.set_look(look); }

  /// The other people, and what is seen of the one who looks.
  [[nodiscard]] PeopleView& people() { return people_; }

  /// Errors as RoomRenderer::draw.
  Status draw(const render::Eyes& eyes, const render::OffscreenTarget& target, render::RenderMode mode);

 private:
  RoomView(render::RoomRenderer renderer, PeopleView people)
      : renderer_(std::move(renderer)), people_(std::move(people)) {}
  struct Uploaded {
    std::shared_ptr<const client::SensorPicture> picture;
    CameraIntrinsics lens;  // another lens empties the surface
  };
  Status show_sensor(const client::RoomSensor& sensor);

  render::RoomRenderer renderer_;
  PeopleView people_;
  std::set<SensorId> hidden_;
  std::unordered_map<SensorId, Uploaded> uploaded_;
};

/// Where a viewer of this room should stand if nobody says otherwise: where the hub put it.
[[nodiscard]] RigidTransform world_from_start_view(const client::RoomSnapshot& room);

}  // namespace roomcast::viewer
