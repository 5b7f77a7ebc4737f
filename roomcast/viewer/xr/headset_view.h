// SPDX-License-Identifier: Apache-2.0
// HeadsetView: the room in a headset: moves its wearer, draws for both eyes at once, and says where
// head and hands are. Threading: the thread of the GL context.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "roomcast/client/room/person_pose.h"
#include "roomcast/viewer/view/room_picture.h"
#include "roomcast/viewer/view/room_view.h"
#include "roomcast/viewer/view/view_settings.h"
#include "roomcast/viewer/xr/headset.h"
#include "roomcast/viewer/xr/vr_walk.h"

namespace roomcast::viewer::xr {

class HeadsetView {
 public:
  /// Errors as Headset::open.
  static Result<std::unique_ptr<HeadsetView>> open();

  /// Errors as Headset::poll.
  Status poll() { return headset_->poll(); }
  /// Somebody wears it: draw() then.
  [[nodiscard]] bool is_running() const { return headset_->is_running(); }

  /// Waits until the headset wants a frame, moves the wearer and draws. `start`: where the wearer
  /// stands at first, and after recentring. Errors as Headset's and RoomView::draw.
  Status draw(RoomView& room, const ViewSettings& settings, const ViewState& start);
  /// At the next frame the wearer stands at the start again.
  void recenter() { is_placed_ = false; }

  /// In the world; of the newest frame.
  [[nodiscard]] const client::PersonPose& pose() const { return pose_; }
  /// What the left eye sees, and behind it what the right one does; null before the first frame.
  [[nodiscard]] const render::OffscreenTarget* left_eye() const { return picture_.target(); }
  [[nodiscard]] std::optional<nanoseconds> take_drawing_time() {
    return picture_.take_drawing_time();
  }
  /// For the panel: the headset's name, its rate, our time for a frame, frames missed.
  [[nodiscard]] std::string report() const;

 private:
  explicit HeadsetView(std::unique_ptr<Headset> headset) : headset_(std::move(headset)) {}
  void move(const VrInput& input, const ViewSettings& settings, const ViewState& start);
  Status find_pointed_at(RoomView& room, const VrInput& input);
  Status draw_eyes(RoomView& room, render::RenderMode mode);
  [[nodiscard]] client::PersonPose seen_of_self(const VrInput& input) const;

  std::unique_ptr<Headset> headset_;
  VrWalk walk_;
  bool is_placed_ = false;
  HostTime last_frame_{};
  client::PersonPose pose_;
  RoomPicture picture_;
  RoomPicture pointed_at_;
};

}  // namespace roomcast::viewer::xr
