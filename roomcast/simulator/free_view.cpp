// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/free_view.h"

#include <algorithm>
#include <cmath>

#include "roomcast/core/assert.h"
#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

/// True if a sensor sees a point of the world, judged by its clean depth of this instant.
bool sees(const SimulatedSensor& sensor, DepthView clean_mm, const Vector3d& point_m) {
  constexpr double kBehind_mm = 12.0;
  const simulator::SensorProfile& profile = sensor.unit().profile;
  const Vector3d in_sensor = sensor.world_from_depth().inverse() * point_m;
  if (in_sensor.z() < static_cast<double>(profile.nearest_m) ||
      in_sensor.z() > static_cast<double>(profile.farthest_m))
    return false;
  const auto pixel = project(sensor.exact_calibration().depth, in_sensor);
  if (!pixel) return false;
  const int left = static_cast<int>(std::floor(pixel->x()));
  const int top = static_cast<int>(std::floor(pixel->y()));
  if (left < 0 || top < 0 || left + 1 >= clean_mm.width || top + 1 >= clean_mm.height) return false;
  const int farthest = std::max({clean_mm.at(left, top), clean_mm.at(left + 1, top),
                                 clean_mm.at(left, top + 1), clean_mm.at(left + 1, top + 1)});
  return 1000.0 * in_sensor.z() <= farthest + kBehind_mm;
}

/// A candidate viewpoint, and the share of its view that some sensor also sees.
struct Candidate {
  RigidTransform world_from_view;
  double score = 0;
};

RigidTransform drawn_place(const simulator::Room& room, std::uint32_t key) {
  const auto signed_unit = [key](std::uint32_t trait) {
    return 2.0 * static_cast<double>(simulator::nth_unit(key, trait)) - 1.0;
  };
  const Vector3d half = 0.5 * room.size_m.cast<double>();
  const Vector3d eye(0.85 * half.x() * signed_unit(1), 1.55 + 0.25 * signed_unit(2),
                     0.85 * half.z() * signed_unit(3));
  const Vector3d target(0.4 * half.x() * signed_unit(4), 0.9 + 0.3 * signed_unit(5),
                        0.4 * half.z() * signed_unit(6));
  return world_from_optical_looking_at(eye, target);
}

bool is_free(const simulator::RayScene& rays, const Vector3f& eye) {
  constexpr float kElbow_m = 0.45F;
  for (int i = 0; i < 27; ++i) {
    const Vector3f way(static_cast<float>(i % 3 - 1), static_cast<float>(i / 3 % 3 - 1),
                       static_cast<float>(i / 9 - 1));
    if (!way.isZero() && rays.blocked(eye, eye + kElbow_m * way.normalized())) return false;
  }
  return true;
}

/// Share of a coarse picture with a surface, at least 0.9 m away, that some sensor also sees.
double share_seen(const SimulatedRoom& room, std::span<const SimulatedSensor* const> sensors,
                  std::span<const DepthImage> depths, const RigidTransform& world_from_view) {
  constexpr int kSide = 24;
  constexpr double kNear_m = 0.9;
  int seen = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const Vector3d ray((i % kSide + 0.5) / kSide * 2.0 - 1.0, (i / kSide + 0.5) / kSide * 2.0 - 1.0,
                       1.0);
    const Vector3d direction = world_from_view.rotation * ray;
    const auto hit =
        room.rays().first_hit(world_from_view.translation_m.cast<float>(), direction.cast<float>());
    if (!hit || static_cast<double>(hit->t) < kNear_m) continue;
    const Vector3d point = world_from_view.translation_m + static_cast<double>(hit->t) * direction;
    bool any = false;
    for (std::size_t s = 0; s < sensors.size() && !any; ++s)
      any = sees(*sensors[s], depths[s], point);
    seen += any;
  }
  return static_cast<double>(seen) / (kSide * kSide);
}

bool alike(const RigidTransform& a, const RigidTransform& b) {
  constexpr double kApart_m = 1.2, kSameWay = 0.6;
  const double cosine = a.rotation.col(2).dot(b.rotation.col(2));
  return (a.translation_m - b.translation_m).norm() < kApart_m ||
         (cosine > kSameWay && (a.translation_m - b.translation_m).norm() < 2.0 * kApart_m);
}

std::vector<Candidate> candidates(const SimulatedRoom& room,
                                  std::span<const SimulatedSensor* const> sensors,
                                  std::uint64_t seed) {
  constexpr std::uint32_t kDraws = 300;
  const auto key = simulator::hash_of(static_cast<std::uint32_t>(seed), 0x76696577U);
  std::vector<DepthImage> depths;
  for (const SimulatedSensor* sensor : sensors) depths.push_back(sensor->depth_camera().still_mm());
  std::vector<Candidate> found;
  for (std::uint32_t draw = 0; draw < kDraws; ++draw) {
    const RigidTransform place = drawn_place(room.room(), simulator::hash_of(key, draw));
    if (!is_free(room.rays(), place.translation_m.cast<float>())) continue;
    found.push_back({place, share_seen(room, sensors, depths, place)});
  }
  return found;
}

}  // namespace

FreeView::FreeView(const SimulatedRoom& room, const CameraIntrinsics& lens,
                   const RigidTransform& world_from_view, const Workers& workers)
    : room_(room),
      camera_(lens, world_from_view),
      plate_(simulator::trace_color_plate(room.room(), room.rays(), camera_, workers)),
      layer_(lens.width, lens.height),
      depth_mm_(lens.width, lens.height) {}

void FreeView::look(const simulator::MovingThings& things) {
  color_ = plate_.color;
  layer_.draw(things, camera_);
  colors_.light(things, room_.room());
  colors_.put_shade(room_.room(), camera_, plate_, color_.view());
  colors_.put(things, layer_, plate_, room_.texels(), color_.view());
  for (int y = 0; y < depth_mm_.height(); ++y) {
    for (int x = 0; x < depth_mm_.width(); ++x) {
      const bool moving = simulator::is_in_front(layer_, plate_.z_m, x, y);
      const float z_m = moving ? layer_.z_m().at(x, y) : plate_.z_m.at(x, y);
      depth_mm_.at(x, y) = static_cast<std::uint16_t>(1000.0F * z_m + 0.5F);
    }
  }
}

MaskImage FreeView::seen_by(std::span<const SimulatedSensor* const> sensors,
                            std::span<const DepthImage> sensor_depths) const {
  ROOMCAST_ASSERT(sensors.size() == sensor_depths.size() && sensors.size() <= kMaxSeeingSensors);
  MaskImage seen(depth_mm_.width(), depth_mm_.height());
  for (int y = 0; y < seen.height(); ++y) {
    for (int x = 0; x < seen.width(); ++x) {
      if (depth_mm_.at(x, y) == 0) continue;
      const bool moving = simulator::is_in_front(layer_, plate_.z_m, x, y);
      const float z_m = moving ? layer_.z_m().at(x, y) : plate_.z_m.at(x, y);
      const Vector3d point = camera_.point(x, y, z_m).cast<double>();
      for (std::size_t s = 0; s < sensors.size(); ++s) {
        if (sees(*sensors[s], sensor_depths[s], point))
          seen.at(x, y) = static_cast<std::uint8_t>(seen.at(x, y) | (1U << s));
      }
    }
  }
  return seen;
}

std::vector<RigidTransform> free_viewpoints(const SimulatedRoom& room,
                                            std::span<const SimulatedSensor* const> sensors,
                                            int count, std::uint64_t seed) {
  std::vector<Candidate> found = candidates(room, sensors, seed);
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  std::vector<RigidTransform> chosen;
  for (const Candidate& candidate : found) {
    if (chosen.size() >= static_cast<std::size_t>(count)) break;
    const bool another = std::none_of(chosen.begin(), chosen.end(), [&](const auto& other) {
      return alike(candidate.world_from_view, other);
    });
    if (another) chosen.push_back(candidate.world_from_view);
  }
  return chosen;
}

}  // namespace roomcast::simulator
