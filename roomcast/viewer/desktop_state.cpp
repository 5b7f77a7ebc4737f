// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/desktop_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "roomcast/viewer/report/room_problems.h"
#include "roomcast/viewer/view/room_view.h"

namespace roomcast::viewer {
namespace {

constexpr double kPivotDistance_m = 3;
/// Position of the hand with the laser pointer, relative to the head.
const Eigen::Vector3d kPointerPlace_m(0.18, -0.22, -0.1);

bool is_same(const render::ViewCamera& a, const render::ViewCamera& b) {
  return a.width == b.width && a.height == b.height && a.vertical_fov_rad == b.vertical_fov_rad &&
         a.world_from_view == b.world_from_view;
}

bool draw_the_same(const ViewSettings& a, const ViewSettings& b) {
  return a.mode == b.mode && a.unseen == b.unseen && a.floor_grid == b.floor_grid &&
         a.hidden == b.hidden;
}

int scaled(int pixels, double scale) {
  return std::max(1, static_cast<int>(std::lround(pixels * scale)));
}

}  // namespace

DesktopState::DesktopState(ViewSettings settings, std::optional<ViewState> start)
    : navigation_(start.value_or(ViewState{})),
      start_(std::move(start)),
      has_start_(start_.has_value()),
      settings_(std::move(settings)),
      applied_(settings_),
      room_(std::make_shared<const client::RoomSnapshot>()) {}

void DesktopState::go_to_start() {
  has_start_ = true;
  navigation_.go_to(start_view());
}

ViewState DesktopState::start_view() const {
  return start_.value_or(view_from_pose(world_from_start_view(*room_), kPivotDistance_m));
}

/// The mode commands are in the order of the modes.
void DesktopState::choose_mode(ViewerCommand command) {
  const auto number =
      static_cast<std::size_t>(command) - static_cast<std::size_t>(ViewerCommand::kModePoints);
  settings_.mode = render::kViewModes.at(number);
}

void DesktopState::point_at(const std::optional<Eigen::Vector3d>& place_m) {
  is_outdated_ |= pointer_.has_value() || place_m.has_value();
  pointer_.reset();
  if (place_m) {
    pointer_ = client::PointerBeam{world_from_view(navigation_.view()) * kPointerPlace_m, *place_m};
  }
}

void DesktopState::notify(const Toast& toast, HostTime now) {
  toasts_.add(toast.kind, toast.sentence, now);
}

void DesktopState::advance(double seconds) {
  const ViewState untouched;
  has_start_ |= navigation_.is_walking() || view().position_m != untouched.position_m ||
                view().yaw_rad != untouched.yaw_rad;
  navigation_.advance(seconds);
  is_outdated_ |= !draw_the_same(settings_, applied_);
  applied_ = settings_;
}

bool DesktopState::follow(std::shared_ptr<const client::RoomSnapshot> newest, HostTime now) {
  const bool is_new = newest->revision != room_->revision;
  if (is_new) {
    room_ = std::move(newest);
    is_outdated_ = true;
    if (!has_start_ && room_->connected) go_to_start();
  }
  if (now - last_report_ >= kReportInterval) {
    last_report_ = now;
    report_.follow(*room_, now);
    toasts_.set_problems(room_problems(*room_, now), now);
  }
  return is_new;
}

render::ViewCamera DesktopState::camera(PictureSize window) const {
  const double wanted =
      settings_.automatic_scale ? automatic_scale_.scale() : settings_.render_scale;
  const double scale = is_full_size_ ? 1 : wanted;
  render::ViewCamera camera;
  camera.width = scaled(window.width, scale);
  camera.height = scaled(window.height, scale);
  camera.vertical_fov_rad = settings_.vertical_fov_rad;
  camera.world_from_view = world_from_view(view());
  return camera;
}

client::PersonPose DesktopState::own_pose() const {
  client::PersonPose pose;
  pose.world_from_head = world_from_view(view());
  pose.pointer = pointer_;
  if (drawn_camera_) pose.view = render::view_angles(*drawn_camera_);
  return pose;
}

PanelFacts DesktopState::facts(HostTime now) const {
  PanelFacts facts{*room_, report_.figures(), latency_.median(now), toasts_.current(now)};
  facts.drawn_per_s = drawn_rate_.per_second();
  facts.drawing_ms = std::chrono::duration<double, std::milli>(drawing_time_).count();
  facts.size = drawn_size_;
  facts.is_worn = was_worn_;
  facts.speed_m_per_s = navigation_.speed_m_per_s();
  return facts;
}

bool DesktopState::must_draw(PictureSize window, bool is_pointing) const {
  return is_outdated_ || is_pointing || pointer_ || !drawn_camera_ ||
         !is_same(*drawn_camera_, camera(window));
}

bool DesktopState::must_show(HostTime now) const {
  return is_outdated_ || now - last_shown_ >= kShowInterval;
}

void DesktopState::drawn(const DrawnPicture& picture) {
  is_outdated_ = true;  // until the window shows the picture
  if (picture.camera) drawn_camera_ = picture.camera;
  drawn_size_ = picture.size;
  was_worn_ = !picture.camera;
  if (picture.drawing_time) {
    drawing_time_ = *picture.drawing_time;
    if (picture.camera && !is_full_size_) automatic_scale_.judge(drawing_time_, picture.begin);
  }
  note_latency(picture.begin);
  drawn_rate_.count(picture.begin, ++pictures_drawn_);
}

void DesktopState::note_latency(HostTime begin) {
  for (const client::RoomSensor& sensor : room_->sensors) {
    if (!sensor.online || !sensor.picture) continue;
    const auto [known, is_first] = drawn_seq_.try_emplace(sensor.id, sensor.picture->seq);
    if (!is_first && known->second == sensor.picture->seq) continue;
    known->second = sensor.picture->seq;
    latency_.shown(*sensor.picture, room_->clock, begin, begin + drawing_time_);
  }
}

void DesktopState::shown(HostTime now) {
  is_outdated_ = false;
  last_shown_ = now;
}

}  // namespace roomcast::viewer
