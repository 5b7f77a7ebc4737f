// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/walk/navigation.h"

#include <algorithm>
#include <cmath>

namespace roomcast::viewer {
namespace {

// As on the page, where one notch of the wheel is 100 pixels.
constexpr double kOrbitPerPixel_rad = 0.006;
constexpr double kLookPerPixel_rad = 0.004;
constexpr double kZoomPerNotch = 0.12;
constexpr double kMaxNotches = 3;
constexpr double kRunFactor = 2.5;
constexpr double kLongestStep_s = 0.1;

constexpr double kSpeedPerNotch = 0.2;
constexpr double kStickTurn_rad_per_s = 1.9;
constexpr double kKeyTurn_rad_per_s = 1.2;  // as on the page

/// Per unit of the speed: forward, right, up; and turning to the left and upwards.
struct Motion {
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  double yaw = 0, pitch = 0;

  Motion& operator+=(const Motion& other) {
    step += other.step;
    yaw += other.yaw;
    pitch += other.pitch;
    return *this;
  }
};

Motion motion_of(WalkKey key) {
  switch (key) {
    case WalkKey::kForward:
      return {{1, 0, 0}};
    case WalkKey::kBack:
      return {{-1, 0, 0}};
    case WalkKey::kLeft:
      return {{0, -1, 0}};
    case WalkKey::kRight:
      return {{0, 1, 0}};
    case WalkKey::kUp:
      return {{0, 0, 1}};
    case WalkKey::kDown:
      return {{0, 0, -1}};
    case WalkKey::kTurnLeft:
      return {{0, 0, 0}, 1, 0};
    case WalkKey::kTurnRight:
      return {{0, 0, 0}, -1, 0};
    case WalkKey::kLookUp:
      return {{0, 0, 0}, 0, 1};
    case WalkKey::kLookDown:
      return {{0, 0, 0}, 0, -1};
  }
  return {};
}

/// 0 while the stick rests, then growing from 0, without a jump at the threshold.
double beyond_rest(double axis) {
  const double beyond = (std::abs(axis) - kStickRest) / (1 - kStickRest);
  return std::copysign(std::clamp(beyond, 0.0, 1.0), axis);
}

Sticks without_rest(const Sticks& sticks) {
  return {beyond_rest(sticks.walk_right), beyond_rest(sticks.walk_forward),
          beyond_rest(sticks.walk_up), beyond_rest(sticks.look_right), beyond_rest(sticks.look_up)};
}

bool is_at_rest(const Sticks& sticks) {
  return sticks.walk_right == 0 && sticks.walk_forward == 0 && sticks.walk_up == 0 &&
         sticks.look_right == 0 && sticks.look_up == 0;
}

}  // namespace

bool Navigation::is_walking() const {
  return !held_.empty() || !is_at_rest(without_rest(sticks_));
}

void Navigation::hold(WalkKey key, bool down) {
  if (down) {
    held_.insert(key);
  } else {
    held_.erase(key);
  }
}

void Navigation::release_all() {
  held_.clear();
  running_ = false;
  sticks_ = {};
}

void Navigation::drag(Drag kind, double dx_px, double dy_px, double picture_height_px,
                      double vertical_fov_rad) {
  const double height_m = 2 * view_.pivot_distance_m * std::tan(vertical_fov_rad / 2);
  const double metres_per_pixel = height_m / std::max(1.0, picture_height_px);
  switch (kind) {
    case Drag::kOrbit:
      view_ = orbit(view_, -dx_px * kOrbitPerPixel_rad, -dy_px * kOrbitPerPixel_rad);
      return;
    case Drag::kPan:
      view_ = pan(view_, -dx_px * metres_per_pixel, dy_px * metres_per_pixel);
      return;
    case Drag::kLook:
      view_ = look(view_, -dx_px * kLookPerPixel_rad, -dy_px * kLookPerPixel_rad);
      return;
  }
}

void Navigation::zoom(double notches) {
  view_ = dolly(view_, std::exp(-kZoomPerNotch * std::clamp(notches, -kMaxNotches, kMaxNotches)));
}

void Navigation::change_speed(double notches) {
  speed_m_per_s_ = std::clamp(speed_m_per_s_ * std::exp(kSpeedPerNotch * notches),
                              kSlowestWalk_m_per_s, kFastestWalk_m_per_s);
}

void Navigation::advance(double seconds) {
  const double step_s = std::clamp(seconds, 0.0, kLongestStep_s);
  const double keys_s = step_s * (running_ ? kRunFactor : 1);
  const Sticks sticks = without_rest(sticks_);
  Motion keys;
  for (const WalkKey key : held_) keys += motion_of(key);
  Eigen::Vector3d step(sticks.walk_forward, sticks.walk_right, sticks.walk_up);
  step = keys_s * speed_m_per_s_ * (step + keys.step);
  view_ = walk(view_, step.x(), step.y(), step.z());
  const double sticks_rad = step_s * kStickTurn_rad_per_s, keys_rad = keys_s * kKeyTurn_rad_per_s;
  view_ = look(view_, keys.yaw * keys_rad - sticks.look_right * sticks_rad,
               keys.pitch * keys_rad + sticks.look_up * sticks_rad);
}

}  // namespace roomcast::viewer
