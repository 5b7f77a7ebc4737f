// SPDX-License-Identifier: Apache-2.0
// DesktopViewer: `roomcast view` in a window. Draws the newest RoomSnapshot, moves the viewer and
// sends the viewer's pose to the hub. Never waits for the network: when the hub or a sensor is
// lost, it keeps drawing the last data and reports the loss. Threading: the window's thread only.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "roomcast/client/subscriber.h"
#include "roomcast/io/numbered_files.h"
#include "roomcast/viewer/capture/capture_writer.h"
#include "roomcast/viewer/hub_report.h"
#include "roomcast/viewer/panel/panel.h"
#include "roomcast/viewer/panel/panel_layer.h"
#include "roomcast/viewer/report/room_report.h"
#include "roomcast/viewer/report/toasts.h"
#include "roomcast/viewer/view/render_scale.h"
#include "roomcast/viewer/view/room_picture.h"
#include "roomcast/viewer/view/room_view.h"
#include "roomcast/viewer/view/view_settings.h"
#include "roomcast/viewer/walk/navigation.h"
#include "roomcast/viewer/window/desktop_input.h"
#include "roomcast/viewer/window/view_window.h"
#include "roomcast/viewer/xr/headset_view.h"

namespace roomcast::viewer {

struct DesktopViewerOptions {
  ViewWindowOptions window;
  ViewSettings settings;
  std::optional<ViewState> start;        // default: the hub's start position
  bool panel = true;                     // shown at the start
  std::filesystem::path pictures = ".";  // folder for screenshots and videos
  io::PictureWriter write_png;           // required
  bool headset = false;                  // also draw for a headset if there is one
};

class DesktopViewer {
 public:
  /// `hub` must outlive the viewer. Errors as ViewWindow::open, PanelLayer::create and
  /// RoomView::create.
  static Result<std::unique_ptr<DesktopViewer>> open(client::Subscriber& hub,
                                                     DesktopViewerOptions options);

  /// One iteration: input, movement, the newest room, drawing, reports to the hub. False: the user
  /// wants to quit.
  bool step();

  /// The window's content: the room and the panel.
  [[nodiscard]] ColorImage window_picture();
  [[nodiscard]] const ViewState& view() const { return navigation_.view(); }
  [[nodiscard]] std::vector<Toast> toasts() const;
  [[nodiscard]] std::uint64_t pictures_drawn() const { return pictures_drawn_; }

 private:
  DesktopViewer(client::Subscriber& hub, DesktopViewerOptions options,
                std::unique_ptr<ViewWindow> window, std::unique_ptr<PanelLayer> panel_layer,
                RoomView room_view);

  [[nodiscard]] HostTime now() const { return clock_.now(); }
  void take_events();
  void obey(ViewerCommand command);
  void choose_mode(ViewerCommand command);
  void set_mouse_look(bool on);
  void release();
  void advance(HostTime now);
  void follow_room(HostTime now);
  void go_to_start();
  void point();
  [[nodiscard]] bool must_draw() const;
  void draw_room(HostTime now);
  void note_shown_pictures(HostTime begin);
  void apply_settings();
  void show(HostTime now);
  void draw_window();
  [[nodiscard]] PanelFacts facts(HostTime now) const;
  [[nodiscard]] render::ViewCamera camera() const;
  [[nodiscard]] client::PersonPose pose_publisher() const;
  [[nodiscard]] bool may_keep_pictures();
  void save_screenshot();
  void start_or_stop_video();
  void record_on();
  void say(const Toast& toast);
  void look_for_headset(HostTime now);
  [[nodiscard]] bool is_in_headset() const { return headset_ && headset_->is_running(); }
  void draw_headset(HostTime now);
  void headset_is_over(const Error& why, HostTime now);
  [[nodiscard]] ViewState start_view() const;
  [[nodiscard]] const render::OffscreenTarget* shown_picture() const;

  SteadyClock clock_;
  client::Subscriber& hub_;
  DesktopViewerOptions options_;
  ViewSettings settings_, applied_;
  std::unique_ptr<ViewWindow> window_;  // before the members that need its GL context
  std::unique_ptr<PanelLayer> panel_layer_;
  RoomView room_view_;
  RoomPicture picture_;
  std::unique_ptr<viewer::xr::HeadsetView> headset_;  // null while there is none
  std::string driver_;

  std::shared_ptr<const client::RoomSnapshot> room_ =
      std::make_shared<const client::RoomSnapshot>();
  std::unordered_map<SensorId, std::uint32_t> shown_seq_;
  Navigation navigation_;
  DesktopInput input_;
  std::optional<client::PointerBeam> pointer_;
  Panel panel_;
  RoomReport report_;
  LatencyBudget latency_;
  HubReport hub_report_;
  CaptureWriter keeper_;
  Toasts toasts_;
  RenderScale automatic_scale_;

  bool wants_to_leave_ = false;
  bool has_start_ = false;      // the view is at the start position, or the user has moved
  bool picture_is_old_ = true;  // the room, the people or the settings have changed
  bool had_input_ = false;
  std::optional<render::ViewCamera> drawn_camera_;
  RateMeter drawn_rate_;
  std::uint64_t pictures_drawn_ = 0;
  nanoseconds drawing_time_{};
  HostTime last_step_{}, last_report_{}, last_shown_{}, headset_looked_for_{};
  std::string headset_trouble_;  // the last one shown
};

}  // namespace roomcast::viewer
