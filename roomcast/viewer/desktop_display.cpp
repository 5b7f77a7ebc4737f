// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/desktop_display.h"

#include <utility>

#include <epoxy/gl.h>

namespace roomcast::viewer {
namespace {

constexpr std::chrono::seconds kHeadsetRetry{5};

std::string driver_name() {
  const GLubyte* const words = glGetString(GL_RENDERER);
  return words != nullptr ? reinterpret_cast<const char*>(words) : "";
}

/// True until there is a headset again.
std::string without_headset(const std::string& why) {
  return "The room is shown on the desktop only: " + why + ".";
}

}  // namespace

Result<DesktopDisplay> DesktopDisplay::open(const ViewWindowOptions& options) {
  auto window = ViewWindow::open(options);
  if (!window) return window.error();
  auto panel_layer = PanelLayer::create(**window);
  if (!panel_layer) return panel_layer.error();
  auto room_view = RoomView::create();
  if (!room_view) return room_view.error();
  return DesktopDisplay(std::move(*window), std::move(*panel_layer), std::move(*room_view));
}

DesktopDisplay::DesktopDisplay(std::unique_ptr<ViewWindow> window,
                               std::unique_ptr<PanelLayer> panel_layer, RoomView room_view)
    : window_(std::move(window)),
      panel_layer_(std::move(panel_layer)),
      room_view_(std::move(room_view)),
      driver_(driver_name()) {}

Status DesktopDisplay::apply(const ViewSettings& settings, const client::RoomSnapshot& room) {
  render::RenderOptions options;
  options.unseen = settings.unseen;
  options.floor_grid = settings.floor_grid;
  if (headset_runs()) {
    if (headset_->adds_light()) options.background = {};
    options.background_is_clear = settings.comfort.sees_through && headset_->may_see_through();
  }
  Status status = room_view_.set_options(options);
  if (settings.hidden != hidden_) {
    hidden_ = settings.hidden;
    room_view_.hide(hidden_);
    static_cast<void>(room_view_.show(room));  // its errors have been shown
  }
  return status;
}

Result<DrawnPicture> DesktopDisplay::draw_room(const DesktopState& state, HostTime now) {
  room_view_.people().set_own(state.pointer() ? std::optional(state.own_pose()) : std::nullopt);
  const render::ViewCamera camera = state.camera(window_->size());
  if (auto status = picture_.draw(room_view_, camera, state.settings().mode); !status) {
    return status.error();
  }
  return DrawnPicture{now, camera, picture_.take_drawing_time(), {camera.width, camera.height}};
}

Result<std::optional<DrawnPicture>> DesktopDisplay::draw_headset(const DesktopState& state,
                                                                 HostTime now) {
  const Status drawn = headset_->draw(room_view_, state.settings(), state.start_view(),
                                      state.sentences_before_eyes(now));
  if (!drawn) return drawn.error();
  if (!state.knows_start()) headset_->recenter();  // in the next frame, again
  if (!headset_->is_seen()) return std::optional<DrawnPicture>();
  const render::OffscreenTarget& eyes = *headset_->left_eye();
  return std::optional(DrawnPicture{
      now, std::nullopt, headset_->take_drawing_time(), {eyes.width(), eyes.height()}});
}

const render::OffscreenTarget* DesktopDisplay::picture() const {
  return is_in_headset() && headset_->left_eye() != nullptr ? headset_->left_eye()
                                                            : picture_.target();
}

std::optional<ViewerCommand> DesktopDisplay::draw_window(PanelFacts facts, Panel& panel,
                                                         ViewSettings& settings) {
  if (const render::OffscreenTarget* shown = picture()) window_->show(*shown);
  facts.driver = driver_;
  if (headset_) {
    facts.headset = headset_->report();
    facts.may_see_through = headset_->may_see_through();
  }
  facts.no_headset = no_headset_;
  panel_layer_->begin();
  const auto command = panel.draw(facts, settings);
  panel_layer_->end();
  return command;
}

std::optional<Eigen::Vector3d> DesktopDisplay::surface_at(
    const std::optional<render::ViewCamera>& camera, double x, double y) const {
  if (!camera || picture_.target() == nullptr) return std::nullopt;
  return viewer::surface_at(*picture_.target(), *camera, static_cast<int>(x * camera->width),
                            static_cast<int>(y * camera->height));
}

std::optional<Toast> DesktopDisplay::poll_headset(HostTime now) {
  if (headset_) {
    if (auto status = headset_->poll(); !status) return close_headset(status.error(), now);
    return std::nullopt;
  }
  if (was_left_) return std::nullopt;
  if (headset_tried_ != HostTime{} && now - headset_tried_ < kHeadsetRetry) return std::nullopt;
  headset_tried_ = now;
  auto opened = xr::HeadsetView::open();
  if (!opened) {
    const std::string now_true = without_headset(opened.error().message);
    if (std::exchange(no_headset_, now_true) == now_true) return std::nullopt;
    return Toast{Toast::Kind::kNotice, no_headset_};
  }
  headset_ = std::move(*opened);
  no_headset_.clear();
  return Toast{Toast::Kind::kGood, "The headset is connected."};
}

void DesktopDisplay::recenter_headset() {
  if (headset_) return headset_->recenter();
  was_left_ = false;
  headset_tried_ = {};
}

Toast DesktopDisplay::close_headset(const Error& why, HostTime now) {
  was_left_ = headset_->has_exited();
  no_headset_ = without_headset(why.message + (was_left_ ? "; press C to go back" : ""));
  headset_.reset();
  headset_tried_ = now;
  return {Toast::Kind::kNotice, no_headset_};
}

}  // namespace roomcast::viewer
