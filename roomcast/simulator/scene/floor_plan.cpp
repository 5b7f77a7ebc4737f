// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/floor_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "roomcast/simulator/scene/furniture.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr int kTries = 60;
constexpr float kGap_m = 0.06F;       // between pieces
constexpr float kWallGap_m = 0.025F;  // skirting boards
constexpr float kSide_m = 0.04F;      // between objects on a wall

float signed_angle_turn(int wall) {
  constexpr float kQuarter = 0.5F * std::numbers::pi_v<float>;
  constexpr std::array<float, 4> kYaw = {kQuarter, -kQuarter, 0.0F, 2.0F * kQuarter};
  return kYaw[static_cast<std::size_t>(wall)];
}

}  // namespace

FloorPlan::FloorPlan(const Vector3f& room_size_m, std::uint32_t seed)
    : size_m_(room_size_m), random_(seed) {}

void FloorPlan::keep_way(const Vector2f& from_m, const Vector2f& to_m, float half_width_m) {
  const Vector2f way = to_m - from_m;
  Footprint strip;
  strip.centre_m = 0.5F * (from_m + to_m);
  strip.half_m = {half_width_m, 0.5F * way.norm() + half_width_m};
  strip.yaw_rad = std::atan2(way.x(), way.y());
  ways_.push_back(strip);
}

void FloorPlan::keep_view(const SensorMount& mount) {
  const Vector2f eye(mount.eye_m.x(), mount.eye_m.z());
  const Vector2f way = (Vector2f(mount.target_m.x(), mount.target_m.z()) - eye).normalized();
  Footprint about{eye, {0.25F, 0.25F}, 0, 0};
  views_.push_back({about, mount.eye_m.y() - 0.35F});
  const Footprint before{eye + 0.75F * way, {0.45F, 0.75F}, std::atan2(way.x(), way.y()), 0};
  views_.push_back({before, mount.eye_m.y() - 0.5F});
}

bool FloorPlan::is_free(const Footprint& footprint) const {
  const float side = std::abs(footprint.side().x()) * footprint.half_m.x() +
                     std::abs(footprint.front().x()) * footprint.half_m.y();
  const float deep = std::abs(footprint.side().y()) * footprint.half_m.x() +
                     std::abs(footprint.front().y()) * footprint.half_m.y();
  if (std::abs(footprint.centre_m.x()) + side > 0.5F * size_m_.x() - 0.014F) return false;
  if (std::abs(footprint.centre_m.y()) + deep > 0.5F * size_m_.z() - 0.014F) return false;
  const auto in_the_way = [&](const Footprint& other) { return overlap(footprint, other, kGap_m); };
  if (std::any_of(taken_.begin(), taken_.end(), in_the_way)) return false;
  const auto on_the_way = [&](const Footprint& other) { return overlap(footprint, other, 0.0F); };
  if (std::any_of(ways_.begin(), ways_.end(), on_the_way)) return false;
  return std::none_of(views_.begin(), views_.end(), [&](const Clearing& view) {
    return footprint.height_m > view.lowest_m && overlap(footprint, view.area, 0.0F);
  });
}

bool FloorPlan::wall_is_free(const WallPatch& patch) const {
  if (std::max(-patch.left_m, patch.right_m) > 0.5F * wall_length(patch.wall) - 0.05F) return false;
  return std::none_of(wall_patches_.begin(), wall_patches_.end(), [&](const WallPatch& other) {
    return other.wall == patch.wall && other.left_m < patch.right_m + kSide_m &&
           patch.left_m < other.right_m + kSide_m && other.bottom_m < patch.top_m + kSide_m &&
           patch.bottom_m < other.top_m + kSide_m;
  });
}

Affine3f FloorPlan::by_wall(int wall, float along_m, float out_m) const {
  const float x = 0.5F * size_m_.x() - out_m;
  const float z = 0.5F * size_m_.z() - out_m;
  const std::array<Vector2f, 4> at = {Vector2f(-x, along_m), Vector2f(x, along_m),
                                      Vector2f(along_m, -z), Vector2f(along_m, z)};
  const Vector2f& point = at[static_cast<std::size_t>(wall)];
  return standing_at(point.x(), point.y(), signed_angle_turn(wall));
}

bool FloorPlan::take(const Affine3f& at, const Vector3f& size_m) {
  const Footprint footprint = footprint_of(at, size_m);
  if (!is_free(footprint)) return false;
  taken_.push_back(footprint);
  return true;
}

std::optional<Affine3f> FloorPlan::try_wall(const Vector3f& size_m, float front_m, int wall,
                                            float along_m) {
  const WallPatch patch{wall, along_m - 0.5F * size_m.x(), along_m + 0.5F * size_m.x(), 0.0F,
                        size_m.y()};
  if (!wall_is_free(patch)) return std::nullopt;
  const Affine3f at = by_wall(wall, along_m, 0.5F * size_m.z() + kWallGap_m);
  const float before = 0.5F * (size_m.z() + front_m) + kGap_m;
  const Footprint front =
      footprint_of(at * Eigen::Translation3f(0, 0, before), {0.9F * size_m.x(), 0.0F, front_m});
  const auto blocks = [&](const Footprint& other) { return overlap(front, other, 0.0F); };
  if (front_m > 0 && std::any_of(taken_.begin(), taken_.end(), blocks)) return std::nullopt;
  if (!take(at, size_m)) return std::nullopt;
  if (front_m > 0) ways_.push_back(front);
  wall_patches_.push_back(patch);
  return at;
}

std::optional<Affine3f> FloorPlan::against_wall(const Vector3f& size_m, float front_m, int wall) {
  for (int i = 0; i < kTries; ++i) {
    const int which = wall == kAnyWall ? random_.below(4) : wall;
    const float slack = 0.5F * (wall_length(which) - size_m.x()) - 0.06F;
    const float along = random_.between(-1.0F, 1.0F) * slack;
    if (slack < 0.0F) continue;
    if (const auto at = try_wall(size_m, front_m, which, along)) return at;
  }
  return std::nullopt;
}

std::optional<Affine3f> FloorPlan::in_corner(const Vector3f& size_m) {
  for (int i = 0; i < 12; ++i) {
    const int wall = random_.below(4);
    const float slack = 0.5F * (wall_length(wall) - size_m.x()) - 0.07F;
    const float along = (random_.chance(0.5F) ? 1.0F : -1.0F) * slack;
    if (const auto at = try_wall(size_m, 0.0F, wall, along)) return at;
  }
  return std::nullopt;
}

std::optional<Affine3f> FloorPlan::in_the_open(const Vector3f& size_m) {
  for (int i = 0; i < kTries; ++i) {
    const float x = random_.between(-0.5F, 0.5F) * (size_m_.x() - size_m.x());
    const float z = random_.between(-0.5F, 0.5F) * (size_m_.z() - size_m.z());
    const float yaw = 0.5F * std::numbers::pi_v<float> * static_cast<float>(random_.below(4)) +
                      random_.between(-0.15F, 0.15F);
    const Affine3f at = standing_at(x, z, yaw);
    if (take(at, size_m)) return at;
  }
  return std::nullopt;
}

std::optional<Affine3f> FloorPlan::on_wall_at(const Vector3f& size_m, float middle_height_m,
                                              int wall) {
  for (int i = 0; i < kTries; ++i) {
    const int which = wall == kAnyWall ? random_.below(4) : wall;
    const float slack = 0.5F * (wall_length(which) - size_m.x()) - 0.12F;
    if (slack < 0.0F) continue;
    const float along = random_.between(-1.0F, 1.0F) * slack;
    const WallPatch patch{which, along - 0.5F * size_m.x(), along + 0.5F * size_m.x(),
                          middle_height_m - 0.5F * size_m.y(), middle_height_m + 0.5F * size_m.y()};
    const Footprint before =
        footprint_of(by_wall(which, along, 0.5F * size_m.z()), {size_m.x(), 0.0F, size_m.z()});
    const bool blocked = std::any_of(taken_.begin(), taken_.end(), [&](const Footprint& other) {
      return other.height_m > patch.bottom_m && overlap(before, other, 0.02F);
    });
    if (blocked || !wall_is_free(patch)) continue;
    wall_patches_.push_back(patch);
    views_.push_back({before, std::max(0.0F, patch.bottom_m)});
    Affine3f at = by_wall(which, along, 0.0F);
    at.translation().y() = middle_height_m;
    return at;
  }
  return std::nullopt;
}

}  // namespace roomcast::simulator
