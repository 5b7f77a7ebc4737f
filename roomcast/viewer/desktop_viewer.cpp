// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/desktop_viewer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <SDL2/SDL.h>
#include <epoxy/gl.h>

namespace roomcast::viewer {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kReportInterval{250};  // of the panel's figures
constexpr milliseconds kPanelInterval{100};   // redraws the window even if nothing moves
constexpr int kIdle_ms = 5;
constexpr std::chrono::seconds kHeadsetRetry{5};
constexpr double kPivotDistance_m = 3;
/// Position of the hand with the laser pointer, relative to the head.
const Eigen::Vector3d kPointerPlace_m(0.18, -0.22, -0.1);

bool is_same(const render::ViewCamera& a, const render::ViewCamera& b) {
  return a.width == b.width && a.height == b.height && a.vertical_fov_rad == b.vertical_fov_rad &&
         a.world_from_view.rotation == b.world_from_view.rotation &&
         a.world_from_view.translation_m == b.world_from_view.translation_m;
}

std::string driver_name() {
  const GLubyte* const words = glGetString(GL_RENDERER);
  return words != nullptr ? reinterpret_cast<const char*>(words) : "";
}

int scaled(int pixels, double scale) {
  return std::max(1, static_cast<int>(std::lround(pixels * scale)));
}

}  // namespace

Result<std::unique_ptr<DesktopViewer>> DesktopViewer::open(client::Subscriber& hub,
                                                           DesktopViewerOptions options) {
  auto window = ViewWindow::open(options.window);
  if (!window) return window.error();
  auto panel_layer = PanelLayer::create(**window);
  if (!panel_layer) return panel_layer.error();
  auto room_view = RoomView::create();
  if (!room_view) return room_view.error();
  return std::unique_ptr<DesktopViewer>(new DesktopViewer(
      hub, std::move(options), std::move(*window), std::move(*panel_layer), std::move(*room_view)));
}

DesktopViewer::DesktopViewer(client::Subscriber& hub, DesktopViewerOptions options,
                             std::unique_ptr<ViewWindow> window,
                             std::unique_ptr<PanelLayer> panel_layer, RoomView room_view)
    : hub_(hub),
      options_(std::move(options)),
      settings_(options_.settings),
      window_(std::move(window)),
      panel_layer_(std::move(panel_layer)),
      room_view_(std::move(room_view)),
      driver_(driver_name()),
      navigation_(options_.start.value_or(ViewState{})),
      hub_report_(hub),
      keeper_(options_.pictures, options_.write_png),
      has_start_(options_.start.has_value()),
      last_step_(now()) {
  if (!options_.panel) panel_.toggle();
  apply_settings();
}

bool DesktopViewer::step() {
  take_events();
  const HostTime begin = now();
  advance(begin);
  follow_room(begin);
  look_for_headset(begin);
  if (is_in_headset()) {
    draw_headset(begin);
  } else if (must_draw()) {
    draw_room(begin);
  }
  if (keeper_.is_recording()) record_on();
  if (had_input_ || picture_is_old_ || now() - last_shown_ >= kPanelInterval) {
    show(now());
  } else {
    SDL_WaitEventTimeout(nullptr, kIdle_ms);
  }
  hub_report_.tell(pose_publisher(), latency_.median(now()), now());
  return !wants_to_leave_;
}

void DesktopViewer::take_events() {
  had_input_ = false;
  const PictureUnderMouse picture{window_->size().height / window_->pixels_per_unit(),
                                  settings_.vertical_fov_rad};
  const ViewState before = navigation_.view();
  for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
    had_input_ = true;
    if (panel_layer_->take(event)) continue;
    if (const auto command = input_.take(event, picture, navigation_)) obey(*command);
  }
  const bool moved = navigation_.view().position_m != before.position_m ||
                     navigation_.view().yaw_rad != before.yaw_rad;
  has_start_ |= moved;
}

void DesktopViewer::obey(ViewerCommand command) {
  switch (command) {
    case ViewerCommand::kStart:
      return go_to_start();
    case ViewerCommand::kMouseLook:
      return set_mouse_look(!input_.mouse_looks());
    case ViewerCommand::kModePoints:
    case ViewerCommand::kModeSplats:
    case ViewerCommand::kModeMesh:
    case ViewerCommand::kModeAdaptive:
    case ViewerCommand::kModeBlend:
      return choose_mode(command);
    case ViewerCommand::kPanel:
      return panel_.toggle();
    case ViewerCommand::kHelp:
      return panel_.toggle_help();
    case ViewerCommand::kFullScreen:
      return window_->set_full_screen(!window_->is_full_screen());
    case ViewerCommand::kScreenshot:
      return save_screenshot();
    case ViewerCommand::kVideo:
      return start_or_stop_video();
    case ViewerCommand::kRecenter:
      if (headset_) headset_->recenter();
      return;
    case ViewerCommand::kRelease:
      return release();
    case ViewerCommand::kQuit:
      wants_to_leave_ = true;
      return;
  }
}

/// The mode commands are in the order of the modes.
void DesktopViewer::choose_mode(ViewerCommand command) {
  const auto number =
      static_cast<std::size_t>(command) - static_cast<std::size_t>(ViewerCommand::kModePoints);
  settings_.mode = render::kRenderModes.at(number);
}

void DesktopViewer::set_mouse_look(bool on) {
  input_.set_mouse_look(on);
  window_->capture_mouse(on);
}

/// Leaves one state per call: mouse look, then help, then full screen.
void DesktopViewer::release() {
  if (input_.mouse_looks()) return set_mouse_look(false);
  if (panel_.shows_help()) return panel_.toggle_help();
  if (window_->is_full_screen()) window_->set_full_screen(false);
}

void DesktopViewer::advance(HostTime at) {
  const double seconds = std::chrono::duration<double>(at - std::exchange(last_step_, at)).count();
  has_start_ |= navigation_.is_walking();
  navigation_.advance(seconds);
  picture_is_old_ |= room_view_.people().advance(seconds);
  apply_settings();
}

void DesktopViewer::apply_settings() {
  render::RenderOptions look;
  look.unseen = settings_.unseen;
  look.floor_grid = settings_.floor_grid;
  if (auto status = room_view_.set_look(look); !status)
    toasts_.say(Toast::Kind::kError, status.error().message, now());
  const bool same_picture = settings_.mode == applied_.mode &&
                            settings_.unseen == applied_.unseen &&
                            settings_.floor_grid == applied_.floor_grid;
  const bool same_sensors = settings_.hidden == applied_.hidden;
  if (!same_sensors) {
    room_view_.hide(settings_.hidden);
    static_cast<void>(room_view_.show(*room_));  // its errors have been shown
  }
  picture_is_old_ |= !same_picture || !same_sensors;
  applied_ = settings_;
}

void DesktopViewer::follow_room(HostTime at) {
  const auto newest = hub_.snapshot();
  if (newest->revision != room_->revision) {
    room_ = newest;
    picture_is_old_ = true;
    hub_report_.follow(*room_);
    if (auto status = room_view_.show(*room_); !status)
      toasts_.say(Toast::Kind::kError, status.error().message, at);
    if (!has_start_ && room_->connected) go_to_start();
  }
  if (at - last_report_ < kReportInterval) return;
  last_report_ = at;
  report_.follow(*room_, at);
  toasts_.problems_are(room_problems(*room_, at), at);
}

void DesktopViewer::go_to_start() {
  has_start_ = true;
  navigation_.go_to(start_view());
}

ViewState DesktopViewer::start_view() const {
  return options_.start.value_or(view_from_pose(world_from_start_view(*room_), kPivotDistance_m));
}

render::ViewCamera DesktopViewer::camera() const {
  const PictureSize window = window_->size();
  const double scale =
      settings_.automatic_scale ? automatic_scale_.scale() : settings_.render_scale;
  render::ViewCamera camera;
  camera.width = scaled(window.width, scale);
  camera.height = scaled(window.height, scale);
  camera.vertical_fov_rad = settings_.vertical_fov_rad;
  camera.world_from_view = world_from_view(navigation_.view());
  return camera;
}

client::PersonPose DesktopViewer::pose_publisher() const {
  if (is_in_headset()) return headset_->pose();
  client::PersonPose pose;
  pose.world_from_head = world_from_view(navigation_.view());
  pose.pointer = pointer_;
  return pose;
}

/// Points at the surface under the mouse, or at the picture's centre during mouse look.
void DesktopViewer::point() {
  const bool had_pointer = std::exchange(pointer_, std::nullopt).has_value();
  picture_is_old_ |= had_pointer || input_.is_pointing();
  if (!input_.is_pointing() || !drawn_camera_ || picture_.target() == nullptr) return;
  const PictureSize window = window_->size();
  const MousePlace mouse = input_.mouse();
  const double units = window_->pixels_per_unit();
  const double x = input_.mouse_looks() ? 0.5 : mouse.x * units / window.width;
  const double y = input_.mouse_looks() ? 0.5 : mouse.y * units / window.height;
  const auto place_m =
      surface_at(*picture_.target(), *drawn_camera_, static_cast<int>(x * drawn_camera_->width),
                 static_cast<int>(y * drawn_camera_->height));
  if (!place_m) return;
  pointer_ = client::PointerBeam{world_from_view(navigation_.view()) * kPointerPlace_m, *place_m};
}

bool DesktopViewer::must_draw() const {
  if (window_->is_hidden() && !keeper_.is_recording()) return false;
  return picture_is_old_ || input_.is_pointing() || pointer_ || !drawn_camera_ ||
         !is_same(*drawn_camera_, camera());
}

void DesktopViewer::draw_room(HostTime begin) {
  point();
  room_view_.people().set_own(pointer_ ? std::optional(pose_publisher()) : std::nullopt);
  const render::ViewCamera eye = camera();
  if (auto status = picture_.draw(room_view_, eye, settings_.mode); !status) {
    toasts_.say(Toast::Kind::kError, status.error().message, begin);
    return;
  }
  drawn_camera_ = eye;
  picture_is_old_ = true;  // the window must be redrawn
  if (const auto time = picture_.take_drawing_time()) {
    drawing_time_ = *time;
    if (!keeper_.is_recording()) automatic_scale_.judge(*time, begin);  // a video keeps its size
  }
  note_shown_pictures(begin);
  drawn_rate_.count(begin, ++pictures_drawn_);
}

void DesktopViewer::note_shown_pictures(HostTime begin) {
  for (const client::RoomSensor& sensor : room_->sensors) {
    if (!sensor.online || !sensor.picture) continue;
    const auto [known, is_first] = shown_seq_.try_emplace(sensor.id, sensor.picture->seq);
    if (!is_first && known->second == sensor.picture->seq) continue;
    known->second = sensor.picture->seq;
    latency_.shown(*sensor.picture, room_->clock, begin, begin + drawing_time_);
  }
  hub_report_.shown(*room_, begin);
}

void DesktopViewer::show(HostTime at) {
  draw_window();
  window_->present();
  picture_is_old_ = false;
  last_shown_ = at;
}

void DesktopViewer::draw_window() {
  if (const render::OffscreenTarget* picture = shown_picture()) window_->show(*picture);
  panel_layer_->begin();
  const auto pressed = panel_.draw(facts(now()), settings_);
  panel_layer_->end();
  if (pressed) obey(*pressed);
}

/// While the headset is worn, the window shows the left eye's picture.
const render::OffscreenTarget* DesktopViewer::shown_picture() const {
  return is_in_headset() && headset_->left_eye() != nullptr ? headset_->left_eye()
                                                            : picture_.target();
}

PanelFacts DesktopViewer::facts(HostTime at) const {
  PanelFacts facts{*room_, report_.figures(), latency_.median(at), toasts_.current(at)};
  facts.drawn_per_s = drawn_rate_.per_second();
  facts.drawing_ms = std::chrono::duration<double, std::milli>(drawing_time_).count();
  facts.width = drawn_camera_ ? drawn_camera_->width : 0;
  facts.height = drawn_camera_ ? drawn_camera_->height : 0;
  facts.speed_m_per_s = navigation_.speed_m_per_s();
  facts.driver = driver_;
  facts.video = keeper_.video_name();
  if (headset_) facts.headset = headset_->report();
  return facts;
}

ColorImage DesktopViewer::window_picture() {
  draw_window();
  return window_->read();
}

std::vector<Toast> DesktopViewer::toasts() const {
  return toasts_.current(now());
}

/// If not, shows the reason.
bool DesktopViewer::may_keep_pictures() {
  const Status may = client::check_may_record(hub_.snapshot()->rights);
  if (!may) say({Toast::Kind::kNotice, may.error().message});
  return may.ok();
}

void DesktopViewer::save_screenshot() {
  if (!may_keep_pictures()) return;
  if (const render::OffscreenTarget* picture = shown_picture())
    say(keeper_.save(*picture, room_->room));
}

void DesktopViewer::start_or_stop_video() {
  if (keeper_.is_recording()) return say(keeper_.stop_video());
  if (!may_keep_pictures()) return;
  if (const render::OffscreenTarget* picture = shown_picture())
    say(keeper_.start_video(*picture, room_->room));
}

/// Stops the video when the picture's size changes, or when the hub no longer permits recording
/// after a reconnection.
void DesktopViewer::record_on() {
  const bool goes_on = room_->rights.may_record && keeper_.record(*shown_picture(), now());
  if (goes_on) return;
  say(keeper_.stop_video());
  if (!room_->rights.may_record) static_cast<void>(may_keep_pictures());
}

void DesktopViewer::say(const Toast& toast) {
  toasts_.say(toast.kind, toast.sentence, now());
}

/// Retries every kHeadsetRetry while there is no headset or after it was lost.
void DesktopViewer::look_for_headset(HostTime at) {
  if (!options_.headset) return;
  if (headset_) {
    if (auto status = headset_->poll(); !status) headset_is_over(status.error(), at);
    return;
  }
  const bool is_soon =
      headset_looked_for_ != HostTime{} && at - headset_looked_for_ < kHeadsetRetry;
  if (is_soon) return;
  headset_looked_for_ = at;
  auto opened = viewer::xr::HeadsetView::open();
  if (!opened) {
    const std::string trouble = opened.error().message;
    if (std::exchange(headset_trouble_, trouble) == trouble) return;  // show it once
    return toasts_.say(Toast::Kind::kNotice,
                       "The room is shown on the desktop only: " + trouble + ".", at);
  }
  headset_ = std::move(*opened);
  headset_trouble_.clear();
  toasts_.say(Toast::Kind::kGood, "The headset is there.", at);
}

void DesktopViewer::draw_headset(HostTime at) {
  if (auto status = headset_->draw(room_view_, settings_, start_view()); !status)
    return headset_is_over(status.error(), at);
  picture_is_old_ = true;
  if (const auto time = headset_->take_drawing_time()) drawing_time_ = *time;
  note_shown_pictures(at);
  drawn_rate_.count(at, ++pictures_drawn_);
}

void DesktopViewer::headset_is_over(const Error& why, HostTime at) {
  headset_.reset();
  headset_looked_for_ = at;
  picture_is_old_ = true;
  toasts_.say(Toast::Kind::kNotice, "The room is shown on the desktop only: " + why.message + ".",
              at);
}

}  // namespace roomcast::viewer
