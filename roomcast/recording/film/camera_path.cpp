// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/film/camera_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "roomcast/io/json_fields.h"
#include "roomcast/render/view/view_camera.h"

namespace roomcast::recording {
namespace {

constexpr double kSwing_rad = 25 * std::numbers::pi / 180;  // to each side
constexpr double kSwingPeriod_s = 12;
constexpr double kSwingKeyEvery_s = 1;

Error refused(std::size_t key, const std::string& what) {
  return {ErrorCode::kInvalidArgument,
          "key " + std::to_string(key) + " of the camera's path " + what};
}

using Place = Eigen::Vector3d CameraKey::*;

/// Velocity at a key, per second, from the neighbouring keys.
Eigen::Vector3d tangent(const std::vector<CameraKey>& keys, std::size_t key, Place place) {
  const CameraKey& before = keys[key == 0 ? 0 : key - 1];
  const CameraKey& after = keys[std::min(key + 1, keys.size() - 1)];
  return (after.*place - before.*place) / (after.time_s - before.time_s);
}

/// Position between `key` and the next key; `u` from 0 to 1.
Eigen::Vector3d hermite(const std::vector<CameraKey>& keys, std::size_t key, double u,
                        Place place) {
  const double span_s = keys[key + 1].time_s - keys[key].time_s;
  const double u2 = u * u, u3 = u2 * u;
  return (2 * u3 - 3 * u2 + 1) * keys[key].*place +
         (u3 - 2 * u2 + u) * span_s * tangent(keys, key, place) +
         (3 * u2 - 2 * u3) * keys[key + 1].*place +
         (u3 - u2) * span_s * tangent(keys, key + 1, place);
}

RigidTransform looking(const CameraKey& key) {
  return render::world_from_view_looking_at(key.eye_m, key.target_m);
}

}  // namespace

Result<CameraPath> CameraPath::create(std::vector<CameraKey> keys) {
  if (keys.empty() || keys.size() > kMaxKeys) {
    return Error{ErrorCode::kInvalidArgument, "a camera's path has 1 to 100000 keys"};
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const CameraKey& key = keys[i];
    if (!std::isfinite(key.time_s) || !key.eye_m.allFinite() || !key.target_m.allFinite())
      return refused(i, "must consist of finite numbers");
    if ((key.target_m - key.eye_m).norm() < kNearestTarget_m)
      return refused(i, "must look at another place than its own");
    if (i > 0 && !(key.time_s > keys[i - 1].time_s))
      return refused(i, "must be later than the one before");
  }
  return CameraPath(std::move(keys));
}

RigidTransform CameraPath::world_from_view(double time_s) const {
  const auto next = std::ranges::upper_bound(keys_, time_s, {}, &CameraKey::time_s);
  if (next == keys_.begin()) return looking(keys_.front());
  if (next == keys_.end()) return looking(keys_.back());
  const auto key = static_cast<std::size_t>(next - keys_.begin()) - 1;
  const double u = (time_s - keys_[key].time_s) / (next->time_s - keys_[key].time_s);
  CameraKey now{time_s, hermite(keys_, key, u, &CameraKey::eye_m),
                hermite(keys_, key, u, &CameraKey::target_m)};
  const bool runs_through_its_target = (now.target_m - now.eye_m).norm() < kNearestTarget_m;
  if (runs_through_its_target) now.target_m = now.eye_m + keys_[key].target_m - keys_[key].eye_m;
  return looking(now);
}

Result<CameraPath> read_camera_path(const std::filesystem::path& file) {
  const auto json = io::read_json_object(file);
  if (!json) return json.error();
  io::JsonProblems problems(file);
  std::vector<CameraKey> keys;
  for (const io::JsonFields& fields : io::JsonFields(*json, "", problems).objects("keys")) {
    const auto place = [&](const char* field) {
      const auto numbers = fields.numbers(field);
      if (numbers.size() == 3) return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
      fields.reject(field, "must be three numbers");
      return Eigen::Vector3d(0, 0, 0);
    };
    keys.push_back({fields.number("time_s"), place("at"), place("look")});
  }
  if (auto status = problems.status(); !status) return status.error();
  auto path = CameraPath::create(std::move(keys));
  if (path) return path;
  return Error{path.error().code, file.string() + ": " + path.error().message};
}

CameraPath swinging_path(const Eigen::Vector3d& eye_m, const Eigen::Vector3d& pivot_m,
                         double length_s) {
  const double longest_s = kSwingKeyEvery_s * (CameraPath::kMaxKeys - 2);
  std::vector<CameraKey> keys;
  for (double t = 0; t < std::min(length_s, longest_s) + kSwingKeyEvery_s; t += kSwingKeyEvery_s) {
    const double angle_rad = kSwing_rad * std::sin(2 * std::numbers::pi * t / kSwingPeriod_s);
    const Eigen::AngleAxisd turn(angle_rad, Eigen::Vector3d::UnitY());
    keys.push_back({t, pivot_m + turn * (eye_m - pivot_m), pivot_m});
  }
  return std::move(CameraPath::create(std::move(keys))).value();
}

}  // namespace roomcast::recording
