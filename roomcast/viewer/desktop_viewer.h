// SPDX-License-Identifier: Apache-2.0
// DesktopViewer: `roomcast view` in a window. Draws the newest RoomSnapshot whose motion is known,
// moves the viewer and sends the viewer's pose to the hub. Never waits for the network: when the
// hub or a sensor is lost, it keeps drawing the last data and reports the loss. Threading: the
// window's thread only.
//
// One way: DesktopInput and the panel turn events into movement and commands, DesktopState is what
// follows from them, from time and from the room, and DesktopDisplay draws it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "roomcast/client/model/model_follower.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/core/log.h"
#include "roomcast/io/numbered_files.h"
#include "roomcast/viewer/capture/capture_writer.h"
#include "roomcast/viewer/desktop_display.h"
#include "roomcast/viewer/desktop_state.h"
#include "roomcast/viewer/hub_report.h"
#include "roomcast/viewer/motion/motion_follower.h"
#include "roomcast/viewer/voice/desktop_voice.h"
#include "roomcast/viewer/window/desktop_input.h"

namespace roomcast::viewer {

struct DesktopViewerOptions {
  ViewWindowOptions window;
  ViewSettings settings;
  std::optional<ViewState> start;                 // default: the hub's start position
  bool panel = true;                              // shown at the start
  std::filesystem::path pictures = ".";           // folder for screenshots and videos
  io::PictureWriter write_png;                    // required
  bool headset = false;                           // also draw for a headset if there is one
  bool voice = false;                             // listen and speak; `hub` has joined with `hears`
  std::optional<client::ModelSource> model = {};  // where to get the room's model; none: nowhere
  LogSink log;                                    // news of the headset; may be empty
};

class DesktopViewer {
 public:
  /// `hub` must outlive the viewer. Errors as DesktopDisplay::open.
  static Result<std::unique_ptr<DesktopViewer>> open(client::Subscriber& hub,
                                                     DesktopViewerOptions options);

  /// One iteration: input, movement, the newest room, drawing, reports to the hub. False: the user
  /// wants to quit.
  bool step();

  /// The window's content: the room and the panel.
  [[nodiscard]] ColorImage window_picture();
  [[nodiscard]] const ViewState& view() const { return state_.view(); }
  [[nodiscard]] std::vector<Toast> toasts() const { return state_.toasts(now()); }
  [[nodiscard]] std::uint64_t pictures_drawn() const { return state_.pictures_drawn(); }
  [[nodiscard]] const ViewWindow& window() const { return display_.window(); }

 private:
  DesktopViewer(client::Subscriber& hub, DesktopViewerOptions options, DesktopDisplay display);

  [[nodiscard]] HostTime now() const { return clock_.now(); }
  // Input. Returns whether there was any.
  bool take_events();
  void run(ViewerCommand command);
  void set_mouse_look(bool on);
  void release();
  // State.
  void advance(HostTime now);
  void follow_room(HostTime now);
  void poll_headset(HostTime now);
  void tell_of_headset(const Toast& news);
  void follow_model();
  void follow_voice();
  // Display.
  void draw(HostTime now);
  bool draw_room(HostTime now);
  [[nodiscard]] std::optional<Eigen::Vector3d> pointed_at() const;
  void take_drawn(const DrawnPicture& picture);
  void draw_window();
  [[nodiscard]] bool may_present(HostTime now) const;
  // Screenshots and videos.
  [[nodiscard]] bool may_capture();
  [[nodiscard]] const render::OffscreenTarget* picture_to_capture();
  void save_screenshot();
  void start_or_stop_video();
  void stop_video();
  void continue_video();
  [[nodiscard]] client::PersonPose own_pose() const;
  void notify(const Toast& toast) { state_.notify(toast, now()); }
  void notify_error(const Status& status);

  SteadyClock clock_;
  client::Subscriber& hub_;
  MotionFollower motion_;
  DesktopViewerOptions options_;
  DesktopDisplay display_;
  DesktopInput input_;
  Panel panel_;
  DesktopState state_;
  CaptureWriter capture_;
  HubReport hub_report_;
  std::unique_ptr<client::ModelFollower> model_;  // null: it is not asked for
  std::unique_ptr<DesktopVoice> voice_;           // null: neither listens nor speaks
  HostTime last_step_{}, last_present_{};
  bool wants_to_quit_ = false;
};

}  // namespace roomcast::viewer
