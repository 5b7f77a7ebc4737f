// SPDX-License-Identifier: Apache-2.0
#include "bench/line/viewer_path.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "roomcast/render/view/view_camera.h"

namespace roomcast::bench {
namespace {

constexpr std::size_t kFields = 17;
constexpr double kEyes_m = 1.6;

/// Unity's z points the other way.
Eigen::Vector3d right_handed(double x, double y, double z) {
  return {x, y, -z};
}

std::optional<ViewerPath::Step> parse_step(std::string line) {
  std::ranges::replace(line, ',', ' ');
  std::istringstream text(line);
  std::vector<double> f;
  for (double number = 0; text >> number;) f.push_back(number);
  if (f.size() != kFields) return std::nullopt;
  const Eigen::Vector3d eye_m = right_handed(f[1], f[2], f[3]);
  const Eigen::Vector3d back = -right_handed(f[11], f[12], f[13]);
  const Eigen::Vector3d up = right_handed(f[14], f[15], f[16]);
  const Eigen::Vector3d right = up.cross(back);
  const bool is_pose = eye_m.squaredNorm() > 0 && std::abs(right.norm() - 1) < 0.01;
  if (!is_pose) return std::nullopt;
  ViewerPath::Step step{nanoseconds(static_cast<std::int64_t>(f[0] * 1e6)), {}};
  step.world_from_head.translation_m = eye_m;
  step.world_from_head.rotation.col(0) = right.normalized();
  step.world_from_head.rotation.col(2) = back.normalized();
  step.world_from_head.rotation.col(1) = back.cross(right).normalized();
  return step;
}

}  // namespace

Result<ViewerPath> ViewerPath::read(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return Error{ErrorCode::kNotFound, "\"" + file.string() + "\" cannot be read"};
  std::vector<Step> steps;
  for (std::string line; std::getline(in, line);) {
    const auto step = parse_step(line);
    if (step && (steps.empty() || step->time > steps.back().time)) steps.push_back(*step);
  }
  if (steps.size() < 2) {
    return Error{ErrorCode::kMalformed, "\"" + file.string() +
                                            "\" has no path of a viewer (a gzipped file must be "
                                            "unpacked first)"};
  }
  const nanoseconds begin = steps.front().time;
  for (Step& step : steps) step.time -= begin;
  return ViewerPath(std::move(steps));
}

ViewerPath ViewerPath::round_walk(double radius_m, nanoseconds length) {
  constexpr std::chrono::milliseconds kStep{50};
  constexpr double kRound_s = 30, kGlance_s = 7;
  std::vector<Step> steps;
  for (nanoseconds time{}; time <= length; time += kStep) {
    const double seconds = std::chrono::duration<double>(time).count();
    const double around = 2 * std::numbers::pi * seconds / kRound_s;
    const double aside = std::pow(std::sin(std::numbers::pi * seconds / kGlance_s), 15);
    const Eigen::Vector3d eye_m(radius_m * std::sin(around), kEyes_m, radius_m * std::cos(around));
    RigidTransform pose = render::world_from_view_looking_at(eye_m, {0, 1.2, 0});
    pose.rotation = Eigen::AngleAxisd(aside * 1.5, Eigen::Vector3d::UnitY()) * pose.rotation;
    steps.push_back({time, pose});
  }
  return ViewerPath(std::move(steps));
}

ViewerPath ViewerPath::around(const Eigen::Vector2d& floor_m) const {
  std::vector<FloorRay> rays;
  for (const Step& step : steps_) {
    const RigidTransform& pose = step.world_from_head;
    const Eigen::Vector3d ahead = -pose.rotation.col(2);
    rays.push_back({{pose.translation_m.x(), pose.translation_m.z()}, {ahead.x(), ahead.z()}});
  }
  const Eigen::Vector2d by_m = floor_m - nearest_to_all(rays);
  ViewerPath moved = *this;
  for (Step& step : moved.steps_)
    step.world_from_head.translation_m += Eigen::Vector3d(by_m.x(), 0, by_m.y());
  return moved;
}

RigidTransform ViewerPath::at(nanoseconds time) const {
  const nanoseconds there_and_back = time % (2 * length());
  const nanoseconds place = std::min(there_and_back, 2 * length() - there_and_back);
  const auto after = std::ranges::upper_bound(steps_, place, {}, &Step::time);
  if (after == steps_.end()) return steps_.back().world_from_head;
  const Step& before = *std::prev(after);
  const double share = std::chrono::duration<double>(place - before.time) /
                       std::chrono::duration<double>(after->time - before.time);
  const Eigen::Quaterniond from(before.world_from_head.rotation),
      to(after->world_from_head.rotation);
  return {from.slerp(share, to).toRotationMatrix(),
          (1 - share) * before.world_from_head.translation_m +
              share * after->world_from_head.translation_m};
}

Eigen::Vector2d nearest_to_all(const std::vector<FloorRay>& rays) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const FloorRay& ray : rays) {
    const double length = ray.direction.norm();
    if (length < 1e-6) continue;
    const Eigen::Vector2d along = ray.direction / length;
    const Eigen::Matrix2d across = Eigen::Matrix2d::Identity() - along * along.transpose();
    normal += across;
    right += across * ray.from_m;
  }
  if (std::abs(normal.determinant()) < 1e-9) return Eigen::Vector2d::Zero();
  return normal.inverse() * right;
}

}  // namespace roomcast::bench
