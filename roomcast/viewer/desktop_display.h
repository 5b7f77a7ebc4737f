// SPDX-License-Identifier: Apache-2.0
// DesktopDisplay: what the desktop viewer draws on: the window with the room's picture and the
// panel, and the headset while it is worn. Needs the window's GL context, which it opens.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "roomcast/viewer/desktop_state.h"
#include "roomcast/viewer/panel/panel_layer.h"
#include "roomcast/viewer/view/room_picture.h"
#include "roomcast/viewer/view/room_view.h"
#include "roomcast/viewer/window/view_window.h"
#include "roomcast/viewer/xr/headset_view.h"

namespace roomcast::viewer {

class DesktopDisplay {
 public:
  /// Errors as ViewWindow::open, PanelLayer::create and RoomView::create.
  static Result<DesktopDisplay> open(const ViewWindowOptions& window);

  [[nodiscard]] ViewWindow& window() { return *window_; }
  [[nodiscard]] const ViewWindow& window() const { return *window_; }
  /// True if the panel consumed the event.
  bool panel_takes(const SDL_Event& event) { return panel_layer_->take(event); }

  /// Sets the room to draw. Errors as RoomView::show.
  Status show_room(const client::RoomSnapshot& room, const RoomMotion& motion) {
    return room_view_.show(room, motion);
  }
  /// Errors as RoomView::take_model.
  Status take_model(const model::DecodedModel& news) { return room_view_.take_model(news); }
  /// Uses the settings from the next picture on; `room` is the room shown. Errors as
  /// RoomView::set_options.
  Status apply(const ViewSettings& settings, const client::RoomSnapshot& room);
  /// Moves the other people. Returns whether the picture has changed.
  bool advance(double seconds) { return room_view_.people().advance(seconds); }

  /// Draws the room for the window. Errors as RoomPicture::draw.
  Result<DrawnPicture> draw_room(const DesktopState& state, HostTime now);
  /// Waits for the headset's next frame and draws the room in it; empty: nobody sees it. After an
  /// error the headset is lost. Errors as HeadsetView::draw.
  Result<std::optional<DrawnPicture>> draw_headset(const DesktopState& state, HostTime now);
  /// The picture that the window shows: the left eye's while the headset is worn. Null before the
  /// first one.
  [[nodiscard]] const render::OffscreenTarget* picture() const;
  /// Draws picture and panel into the window; present() then makes them visible. Returns a command
  /// if the user gave one on the panel.
  std::optional<ViewerCommand> draw_window(PanelFacts facts, Panel& panel, ViewSettings& settings);
  /// The surface of the window's picture at a place, each 0..1 from the top left; empty if there is
  /// none. World frame, metres.
  [[nodiscard]] std::optional<Eigen::Vector3d> surface_at(
      const std::optional<render::ViewCamera>& camera, double x, double y) const;

  /// Opens the headset, if there is one, and notices its loss; tries again every few seconds,
  /// unless the wearer has left.
  /// Returns the news for the user.
  std::optional<Toast> poll_headset(HostTime now);
  /// True while the headset sets the pace: then call draw_headset().
  [[nodiscard]] bool headset_runs() const { return headset_ && headset_->is_running(); }
  /// True while the room is seen in the headset.
  [[nodiscard]] bool is_in_headset() const { return headset_ && headset_->is_seen(); }
  /// The wearer's pose; only while is_in_headset().
  [[nodiscard]] const client::PersonPose& headset_pose() const { return headset_->pose(); }
  /// Moves the wearer to the start. If the wearer has left the room, opens the headset again.
  void recenter_headset();
  /// The headset is lost, or the wearer has left; the desktop goes on. Returns the news for the
  /// user.
  Toast close_headset(const Error& why, HostTime now);

 private:
  DesktopDisplay(std::unique_ptr<ViewWindow> window, std::unique_ptr<PanelLayer> panel_layer,
                 RoomView room_view);

  std::unique_ptr<ViewWindow> window_;  // before the members that need its GL context
  std::unique_ptr<PanelLayer> panel_layer_;
  RoomView room_view_;
  RoomPicture picture_;
  std::set<SensorId> hidden_;
  std::string driver_;

  std::unique_ptr<xr::HeadsetView> headset_;  // null while there is none
  HostTime headset_tried_{};
  bool was_left_ = false;   // by the wearer, who has to ask for the headset again
  std::string no_headset_;  // a sentence that says why; empty: there is one, or none was sought
};

}  // namespace roomcast::viewer
