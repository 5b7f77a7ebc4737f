// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/moved_cabinet.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "roomcast/simulator/scene/furniture.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

const Vector3f kCabinetSize_m(0.6F, 1.0F, 0.4F);
constexpr float kFromWalls_m = 0.6F, kFromFurniture_m = 0.15F, kFromWays_m = 0.5F;
constexpr float kApart_m = 1.0F, kGridStep_m = 0.1F;

float way_distance_m(const Vector2f& at_m, const Vector2f& from_m, const Vector2f& to_m) {
  const Vector2f way = to_m - from_m;
  const float share = way.squaredNorm() > 0 ? (at_m - from_m).dot(way) / way.squaredNorm() : 0;
  return (from_m + std::clamp(share, 0.0F, 1.0F) * way - at_m).norm();
}

bool somebody_walks(const Room& room, const Vector2f& at_m) {
  return std::ranges::any_of(room.people, [&](const Person& person) {
    if (person.stops.empty()) return false;
    Vector2f before_m = person.stops.back().at_m;
    for (const Waypoint& stop : person.stops) {
      std::vector<Vector2f> way = stop.via_m;
      way.push_back(stop.at_m);
      for (const Vector2f& next_m : way) {
        if (way_distance_m(at_m, before_m, next_m) < kFromWays_m) return true;
        before_m = next_m;
      }
    }
    return false;
  });
}

Eigen::Affine3f floor_frame(const Vector2f& at_m) {
  return Eigen::Affine3f(Eigen::Translation3f(at_m.x(), 0, at_m.y()));
}

std::vector<Vector2f> free_middles(const Room& room) {
  std::vector<Vector2f> free;
  const Vector2f half_m(0.5F * room.size_m.x() - kFromWalls_m,
                        0.5F * room.size_m.z() - kFromWalls_m);
  for (float z = -half_m.y(); z <= half_m.y(); z += kGridStep_m) {
    for (float x = -half_m.x(); x <= half_m.x(); x += kGridStep_m) {
      const Footprint here = footprint_of(floor_frame({x, z}), kCabinetSize_m);
      const bool is_taken = std::ranges::any_of(room.footprints, [&](const Footprint& other) {
        return overlap(here, other, kFromFurniture_m);
      });
      if (!is_taken && !somebody_walks(room, {x, z})) free.emplace_back(x, z);
    }
  }
  std::ranges::stable_sort(free, {}, &Vector2f::squaredNorm);
  return free;
}

std::optional<std::array<Vector2f, 2>> two_places(const Room& room) {
  const std::vector<Vector2f> free = free_middles(room);
  if (free.empty()) return std::nullopt;
  const auto other = std::ranges::find_if(
      free, [&](const Vector2f& at_m) { return (at_m - free.front()).norm() >= kApart_m; });
  if (other == free.end()) return std::nullopt;
  return std::array{free.front(), *other};
}

}  // namespace

std::optional<std::array<Eigen::AlignedBox3f, 2>> cabinet_places(const Room& room) {
  const auto middles = two_places(room);
  if (!middles) return std::nullopt;
  const auto box = [](const Vector2f& at_m) {
    const Vector3f middle(at_m.x(), 0.5F * kCabinetSize_m.y(), at_m.y());
    return Eigen::AlignedBox3f(middle - 0.5F * kCabinetSize_m, middle + 0.5F * kCabinetSize_m);
  };
  return std::array{box((*middles)[0]), box((*middles)[1])};
}

bool add_cabinet(Room& room, int place) {
  const auto middles = two_places(room);
  if (!middles) return false;
  const SurfaceIndex wood = room.add(painted(Pattern::kWood, 0x9a6a42, 0x7c5233, 0.3F, 7));
  const SurfaceIndex handles = room.add(painted(Pattern::kFlat, 0x303336, 0, 0, 8));
  const Eigen::Affine3f at = floor_frame(middles->at(static_cast<std::size_t>(place)));
  add_sideboard(room, at, wood, handles, kCabinetSize_m);
  room.footprints.push_back(footprint_of(at, kCabinetSize_m));
  return true;
}

}  // namespace roomcast::simulator
