// SPDX-License-Identifier: Apache-2.0
// DesktopState: what the desktop viewer knows between two pictures: the viewer's place, the
// settings, the newest room, figures and sentences for the panel, and whether the picture is out of
// date. Changed by input, time and new rooms; says what to draw. Pure: no window, no OpenGL, no
// network.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "roomcast/client/room/person_pose.h"
#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/render/view/view_camera.h"
#include "roomcast/viewer/panel/panel.h"
#include "roomcast/viewer/report/rate_meter.h"
#include "roomcast/viewer/report/room_report.h"
#include "roomcast/viewer/report/toasts.h"
#include "roomcast/viewer/view/render_scale.h"
#include "roomcast/viewer/view/view_settings.h"
#include "roomcast/viewer/view/view_target.h"
#include "roomcast/viewer/walk/navigation.h"

namespace roomcast::viewer {

/// A picture of the room that was drawn.
struct DrawnPicture {
  HostTime begin{};
  std::optional<render::ViewCamera> camera;  // of the window's picture; empty: for a headset
  std::optional<nanoseconds> drawing_time;   // of the newest picture whose time is known
  PictureSize size = {};                     // or that of each eye's picture
};

class DesktopState {
 public:
  static constexpr std::chrono::milliseconds kReportInterval{250};  // of the panel's figures
  static constexpr std::chrono::milliseconds kShowInterval{100};    // even if nothing has changed

  /// `start`: where the viewer starts; empty: where the hub says, once the room is known.
  DesktopState(ViewSettings settings, std::optional<ViewState> start);

  // Input.
  [[nodiscard]] Navigation& navigation() { return navigation_; }
  [[nodiscard]] ViewSettings& settings() { return settings_; }
  void go_to_start();
  /// `command`: one of kModePoints to kModeStill.
  void choose_mode(ViewerCommand command);
  /// The laser pointer ends at this point of the world; empty: it is off, or hits no surface.
  void point_at(const std::optional<Eigen::Vector3d>& place_m);
  void notify(const Toast& toast, HostTime now);

  // Time and the hub.
  /// Moves the viewer; changed settings make the picture out of date.
  void advance(double seconds);
  /// Returns whether `newest` differs from the room so far. Call it often, also without a change.
  bool follow(std::shared_ptr<const client::RoomSnapshot> newest, HostTime now);

  // What to draw.
  [[nodiscard]] const ViewState& view() const { return navigation_.view(); }
  [[nodiscard]] const ViewSettings& settings() const { return settings_; }
  [[nodiscard]] const client::RoomSnapshot& room() const { return *room_; }
  [[nodiscard]] ViewState start_view() const;
  /// False until the hub has said where viewers start.
  [[nodiscard]] bool knows_start() const { return start_.has_value() || room_->connected; }
  /// For a window of this size, pixels; at a lower resolution if the settings want that.
  [[nodiscard]] render::ViewCamera camera(PictureSize window) const;
  /// For screenshots and videos: pictures have the window's size, whatever the settings want.
  void draw_at_full_size(bool on) { is_full_size_ = on; }
  /// The camera of the window's newest picture.
  [[nodiscard]] const std::optional<render::ViewCamera>& drawn_camera() const {
    return drawn_camera_;
  }
  [[nodiscard]] const std::optional<client::PointerBeam>& pointer() const { return pointer_; }
  /// The pose of a viewer without a headset.
  [[nodiscard]] client::PersonPose own_pose() const;
  [[nodiscard]] PanelFacts facts(HostTime now) const;
  [[nodiscard]] std::vector<Toast> toasts(HostTime now) const { return toasts_.current(now); }
  [[nodiscard]] std::vector<Toast> sentences_before_eyes(HostTime now) const {
    return toasts_.before_eyes(now);
  }
  [[nodiscard]] std::optional<LatencyStages> latency(HostTime now) const {
    return latency_.median(now);
  }
  [[nodiscard]] std::uint64_t pictures_drawn() const { return pictures_drawn_; }

  // Drawing.
  /// Whether the room must be drawn for a window of this size. While the user points, always: only
  /// the picture shows what the pointer hits.
  [[nodiscard]] bool must_draw(PictureSize window, bool is_pointing) const;
  /// Whether the window must show the picture and the panel again.
  [[nodiscard]] bool must_show(HostTime now) const;
  /// Something that the picture shows has changed.
  void redraw() { is_outdated_ = true; }
  /// Takes note of it.
  void drawn(const DrawnPicture& picture);
  void shown(HostTime now);

 private:
  void note_latency(HostTime begin);

  Navigation navigation_;
  std::optional<ViewState> start_;
  bool has_start_;  // the viewer is at the start position, or has moved
  ViewSettings settings_, applied_;
  std::shared_ptr<const client::RoomSnapshot> room_;
  std::optional<client::PointerBeam> pointer_;

  RoomReport report_;
  LatencyBudget latency_;
  Toasts toasts_;
  HostTime last_report_{};

  bool is_outdated_ = true;  // the room, the people or the settings have changed
  std::optional<render::ViewCamera> drawn_camera_;
  PictureSize drawn_size_;
  bool was_worn_ = false;  // the last picture was the headset's
  std::unordered_map<SensorId, std::uint32_t> drawn_seq_;
  RenderScale automatic_scale_;
  bool is_full_size_ = false;
  nanoseconds drawing_time_{};
  RateMeter drawn_rate_;
  std::uint64_t pictures_drawn_ = 0;
  HostTime last_shown_{};
};

}  // namespace roomcast::viewer
