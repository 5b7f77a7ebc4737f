// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/desktop_viewer.h"

#include <utility>

#include <SDL2/SDL.h>

namespace roomcast::viewer {
namespace {

constexpr int kIdle_ms = 5;
constexpr std::chrono::milliseconds kPresentBesideHeadset{33};

}  // namespace

Result<std::unique_ptr<DesktopViewer>> DesktopViewer::open(client::Subscriber& hub,
                                                           DesktopViewerOptions options) {
  auto display = DesktopDisplay::open(options.window);
  if (!display) return display.error();
  return std::unique_ptr<DesktopViewer>(
      new DesktopViewer(hub, std::move(options), std::move(*display)));
}

DesktopViewer::DesktopViewer(client::Subscriber& hub, DesktopViewerOptions options,
                             DesktopDisplay display)
    : hub_(hub),
      motion_(hub),
      options_(std::move(options)),
      display_(std::move(display)),
      state_(options_.settings, options_.start),
      capture_(options_.pictures, options_.write_png),
      hub_report_(hub),
      last_step_(now()) {
  if (!options_.panel) panel_.toggle();
  if (options_.model) model_ = std::make_unique<client::ModelFollower>(*options_.model);
  if (options_.voice) voice_ = std::make_unique<DesktopVoice>(hub, options_.settings.voice);
  notify_error(display_.apply(state_.settings(), state_.room()));
}

bool DesktopViewer::step() {
  const bool had_input = take_events();
  const HostTime begin = now();
  advance(begin);
  follow_room(begin);
  follow_model();
  poll_headset(begin);
  follow_voice();
  draw(begin);
  if (capture_.is_recording()) continue_video();
  display_.window().wait_for_screen(!display_.headset_runs());
  if ((had_input || state_.must_show(now())) && may_present(now())) {
    draw_window();
    display_.window().present();
    last_present_ = now();
    state_.shown(last_present_);
  } else if (!display_.headset_runs()) {
    SDL_WaitEventTimeout(nullptr, kIdle_ms);
  }
  hub_report_.send(own_pose(), state_.latency(now()), now());
  return !wants_to_quit_;
}

/// The screen must not slow down a headset, which is faster and waits in draw_headset().
bool DesktopViewer::may_present(HostTime at) const {
  if (!display_.headset_runs()) return true;
  return !display_.window().is_hidden() && at - last_present_ >= kPresentBesideHeadset;
}

bool DesktopViewer::take_events() {
  const ViewWindow& window = display_.window();
  const PictureUnderMouse picture{window.size().height / window.pixels_per_unit(),
                                  state_.settings().vertical_fov_rad};
  bool any = false;
  for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
    any = true;
    if (display_.panel_takes(event)) continue;
    if (const auto command = input_.take(event, picture, state_.navigation())) run(*command);
  }
  return any;
}

void DesktopViewer::run(ViewerCommand command) {
  ViewWindow& window = display_.window();
  switch (command) {
    case ViewerCommand::kStart:
      return state_.go_to_start();
    case ViewerCommand::kMouseLook:
      return set_mouse_look(!input_.mouse_looks());
    case ViewerCommand::kModePoints:
    case ViewerCommand::kModeSplats:
    case ViewerCommand::kModeMesh:
    case ViewerCommand::kModeAdaptive:
    case ViewerCommand::kModeBlend:
    case ViewerCommand::kModeStill:
      return state_.choose_mode(command);
    case ViewerCommand::kPanel:
      return panel_.toggle();
    case ViewerCommand::kHelp:
      return panel_.toggle_help();
    case ViewerCommand::kFullScreen:
      return window.set_full_screen(!window.is_full_screen());
    case ViewerCommand::kScreenshot:
      return save_screenshot();
    case ViewerCommand::kVideo:
      return start_or_stop_video();
    case ViewerCommand::kMicrophone:
      state_.settings().voice.microphone_on = !state_.settings().voice.microphone_on;
      return;
    case ViewerCommand::kRecenter:
      return display_.recenter_headset();
    case ViewerCommand::kRelease:
      return release();
    case ViewerCommand::kQuit:
      wants_to_quit_ = true;
      return;
  }
}

void DesktopViewer::set_mouse_look(bool on) {
  input_.set_mouse_look(on);
  display_.window().capture_mouse(on);
}

/// Leaves one state per call: mouse look, then help, then full screen.
void DesktopViewer::release() {
  if (input_.mouse_looks()) return set_mouse_look(false);
  if (panel_.shows_help()) return panel_.toggle_help();
  if (display_.window().is_full_screen()) display_.window().set_full_screen(false);
}

void DesktopViewer::advance(HostTime at) {
  const double seconds = std::chrono::duration<double>(at - std::exchange(last_step_, at)).count();
  state_.advance(seconds);
  if (display_.advance(seconds)) state_.redraw();
  notify_error(display_.apply(state_.settings(), state_.room()));
}

void DesktopViewer::follow_room(HostTime at) {
  const auto newest = motion_.newest();
  if (!state_.follow(newest->room, at)) return;
  hub_report_.follow(state_.room());
  notify_error(display_.show_room(state_.room(), newest->motion));
}

void DesktopViewer::follow_model() {
  if (!model_) return;
  if (!state_.room().room.empty()) model_->follow(state_.room().room);
  for (const model::DecodedModel& news : model_->take()) {
    notify_error(display_.take_model(news));
    state_.redraw();
  }
}

void DesktopViewer::follow_voice() {
  if (!voice_) return;
  state_.settings().voice.is_pushed = input_.is_talking();
  voice_->apply(state_.settings().voice);
  voice_->stand(own_pose().world_from_head);
}

void DesktopViewer::poll_headset(HostTime at) {
  if (!options_.headset) return;
  if (const auto news = display_.poll_headset(at)) tell_of_headset(*news);
}

/// In the window and in the log; the panel keeps showing what is true.
void DesktopViewer::tell_of_headset(const Toast& news) {
  state_.redraw();
  notify(news);
  const bool is_good = news.kind == Toast::Kind::kGood;
  if (options_.log) options_.log(is_good ? LogLevel::kInfo : LogLevel::kWarning, news.sentence);
}

void DesktopViewer::draw(HostTime at) {
  if (display_.headset_runs()) {
    const bool was_seen = display_.is_in_headset();
    const auto drawn = display_.draw_headset(state_, at);
    if (drawn && *drawn) return take_drawn(**drawn);
    if (was_seen || !drawn) state_.redraw();
    if (!drawn) return tell_of_headset(display_.close_headset(drawn.error(), at));
  }
  const bool is_shown = !display_.window().is_hidden() || capture_.is_recording();
  const bool is_seen = is_shown && may_present(at);
  if (!is_seen || !state_.must_draw(display_.window().size(), input_.is_pointing())) return;
  draw_room(at);
}

/// Returns whether it was drawn; if not, shows the reason.
bool DesktopViewer::draw_room(HostTime at) {
  state_.point_at(pointed_at());
  const auto drawn = display_.draw_room(state_, at);
  if (drawn) {
    take_drawn(*drawn);
  } else {
    state_.notify({Toast::Kind::kError, drawn.error().message}, at);
  }
  return drawn.ok();
}

void DesktopViewer::take_drawn(const DrawnPicture& picture) {
  state_.drawn(picture);
  hub_report_.shown(state_.room(), picture.begin);
}

/// The surface under the mouse, or at the picture's centre during mouse look; empty unless the user
/// points.
std::optional<Eigen::Vector3d> DesktopViewer::pointed_at() const {
  if (!input_.is_pointing()) return std::nullopt;
  if (input_.mouse_looks()) return display_.surface_at(state_.drawn_camera(), 0.5, 0.5);
  const ViewWindow& window = display_.window();
  const double units = window.pixels_per_unit();
  return display_.surface_at(state_.drawn_camera(), input_.mouse().x * units / window.size().width,
                             input_.mouse().y * units / window.size().height);
}

void DesktopViewer::draw_window() {
  PanelFacts facts = state_.facts(now());
  facts.video = capture_.video_name();
  if (voice_) facts.voice = voice_->facts();
  if (const auto command = display_.draw_window(std::move(facts), panel_, state_.settings())) {
    run(*command);
  }
}

ColorImage DesktopViewer::window_picture() {
  draw_window();
  return display_.window().read();
}

client::PersonPose DesktopViewer::own_pose() const {
  return display_.is_in_headset() ? display_.headset_pose() : state_.own_pose();
}

/// If not, shows the reason.
bool DesktopViewer::may_capture() {
  const Status may = client::check_may_record(hub_.snapshot()->rights);
  if (!may) notify({Toast::Kind::kNotice, may.error().message});
  return may.ok();
}

/// The headset's, or the window's in the window's size, although fewer pixels may be drawn when
/// nobody captures them. Null, and the reason is shown, if there is none.
const render::OffscreenTarget* DesktopViewer::picture_to_capture() {
  if (!may_capture()) return nullptr;
  state_.draw_at_full_size(true);
  const bool is_ready =
      display_.is_in_headset() || !state_.must_draw(display_.window().size(), false);
  return is_ready || draw_room(now()) ? display_.picture() : nullptr;
}

void DesktopViewer::save_screenshot() {
  if (const auto* picture = picture_to_capture())
    notify(capture_.save(*picture, state_.room().room));
  state_.draw_at_full_size(capture_.is_recording());
}

void DesktopViewer::start_or_stop_video() {
  if (capture_.is_recording()) return stop_video();
  if (const auto* picture = picture_to_capture())
    notify(capture_.start_video(*picture, state_.room().room));
  state_.draw_at_full_size(capture_.is_recording());
}

void DesktopViewer::stop_video() {
  notify(capture_.stop_video());
  state_.draw_at_full_size(false);
}

/// Stops the video when the picture's size changes, or when the hub no longer permits recording
/// after a reconnection.
void DesktopViewer::continue_video() {
  const bool may_record = state_.room().rights.may_record;
  if (may_record && capture_.record(*display_.picture(), now())) return;
  stop_video();
  if (!may_record) static_cast<void>(may_capture());
}

void DesktopViewer::notify_error(const Status& status) {
  if (!status) notify({Toast::Kind::kError, status.error().message});
}

}  // namespace roomcast::viewer
