// SPDX-License-Identifier: Apache-2.0
// RoomView: draws the room received by a Subscriber, and the people in it. Updates the renderer
// from the snapshots and uploads only new pictures. Threading: the thread of its GL context.
#pragma once

#include <memory>
#include <set>
#include <unordered_map>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/core/result.h"
#include "roomcast/model/pieces/decoded_model.h"
#include "roomcast/render/room_renderer.h"
#include "roomcast/render/view/eyes.h"
#include "roomcast/render/view/offscreen_target.h"
#include "roomcast/viewer/motion/room_motion.h"
#include "roomcast/viewer/people/people_view.h"

namespace roomcast::viewer {

class RoomView {
 public:
  /// Needs a current GL context. Errors as RoomRenderer::create.
  static Result<RoomView> create();

  /// Sets the room to draw, and how its newest pictures move. Errors as RoomRenderer::set_sensor
  /// and upload; after an error the other sensors are drawn all the same.
  Status show(const client::RoomSnapshot& room, const RoomMotion& motion = {});

  /// What is new of the room's model, or all of it. Errors as RoomRenderer::set_model_piece; the
  /// other pieces are taken all the same.
  Status take_model(const model::DecodedModel& news);

  /// Sets the sensors not to draw; takes effect at the next show().
  void hide(std::set<SensorId> sensors) { hidden_ = std::move(sensors); }
  /// Errors as RoomRenderer::set_options.
  Status set_options(const render::RenderOptions& options) {
    return renderer_.set_options(options);
  }

  /// The other people, and the visible parts of this viewer.
  [[nodiscard]] PeopleView& people() { return people_; }

  /// Errors as RoomRenderer::draw.
  Status draw(const render::Eyes& eyes, const render::OffscreenTarget& target,
              render::RenderMode mode);

 private:
  RoomView(render::RoomRenderer renderer, PeopleView people)
      : renderer_(std::move(renderer)), people_(std::move(people)) {}
  struct Uploaded {
    std::shared_ptr<const client::SensorPicture> picture;
    CameraIntrinsics lens;  // a change of it clears the surface
    bool is_cleared = false;
  };
  Status show_sensor(const client::RoomSensor& sensor, bool is_late, const RoomMotion& motion);
  Status clear_surface(const client::RoomSensor& sensor, Uploaded& uploaded);

  render::RoomRenderer renderer_;
  PeopleView people_;
  std::set<SensorId> hidden_;
  std::unordered_map<SensorId, Uploaded> uploaded_;
};

/// The default start pose of a viewer, as given by the hub.
[[nodiscard]] RigidTransform world_from_start_view(const client::RoomSnapshot& room);

}  // namespace roomcast::viewer
