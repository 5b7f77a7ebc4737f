// SPDX-License-Identifier: Apache-2.0
// HeadsetView: the room in a headset: moves the wearer, draws for both eyes at once, and returns
// the poses of head and hands. Threading: the thread of the GL context.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/client/room/person_pose.h"
#include "roomcast/viewer/report/toasts.h"
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
  /// True while the headset wants frames: then call draw().
  [[nodiscard]] bool is_running() const { return headset_->is_running(); }
  /// True if the newest frame was seen: not while the headset lies on a desk, or behind another
  /// program.
  [[nodiscard]] bool is_seen() const { return is_seen_ && is_running(); }
  /// True if the displays add the picture to what the wearer sees anyway: black is nothing.
  [[nodiscard]] bool adds_light() const { return headset_->adds_light(); }
  /// True if the displays can show what is around the wearer.
  [[nodiscard]] bool may_see_through() const { return headset_->may_see_through(); }
  [[nodiscard]] bool has_exited() const { return headset_->has_exited(); }

  /// Waits until the headset wants a frame, moves the wearer and draws. `start`: the wearer's
  /// position at the start and after recentring; `sentences`: before the wearer's eyes. Errors as
  /// Headset's and RoomView::draw.
  Status draw(RoomView& room, const ViewSettings& settings, const ViewState& start,
              const std::vector<Toast>& sentences);
  /// Moves the wearer to the start at the next frame.
  void recenter() { is_placed_ = false; }

  /// The wearer's pose in the newest frame that was seen, world frame.
  [[nodiscard]] const client::PersonPose& pose() const { return pose_; }
  /// The two-eye picture, left eye at the left; null before the first frame.
  [[nodiscard]] const render::OffscreenTarget* left_eye() const { return picture_.target(); }
  [[nodiscard]] std::optional<nanoseconds> take_drawing_time() {
    return picture_.take_drawing_time();
  }
  /// For the panel: the headset's name, its rate, the viewer's time per frame, missed frames.
  [[nodiscard]] std::string report() const;

 private:
  explicit HeadsetView(std::unique_ptr<Headset> headset) : headset_(std::move(headset)) {}
  void move(const VrInput& input, const ViewSettings& settings, const ViewState& start);
  Status find_pointed_at(RoomView& room, const VrHand* pointing);
  Status draw_eyes(RoomView& room, render::RenderMode mode);
  [[nodiscard]] client::PersonPose seen_of_self(const VrInput& input,
                                                const ComfortOptions& comfort) const;

  std::unique_ptr<Headset> headset_;
  VrWalk walk_;
  bool is_placed_ = false, is_seen_ = false;
  HostTime last_frame_{};
  client::PersonPose pose_;
  RoomPicture picture_;
  RoomPicture pointed_at_;
};

}  // namespace roomcast::viewer::xr
