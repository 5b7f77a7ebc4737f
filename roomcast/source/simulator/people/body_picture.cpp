// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/people/body_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "roomcast/source/simulator/tracing/lighting.h"

namespace roomcast::sim {
namespace {

using Eigen::Vector3f;

bool body_in_front(const BodyLayer& layer, const Image<float>& plate_z_m, int x, int y) {
  const float behind = plate_z_m.at(x, y);
  const float z = layer.z_m().at(x, y);
  return std::isfinite(z) && (behind == 0.0F || z < behind);
}

float nearest_z(const BodyLayer& layer, const Image<float>& plate_z_m, int x, int y) {
  return body_in_front(layer, plate_z_m, x, y) ? layer.z_m().at(x, y) : plate_z_m.at(x, y);
}

PixelBox grown(const PixelBox& box, int width, int height) {
  return {std::max(0, box.left - 1), std::max(0, box.top - 1), std::min(width, box.right + 1),
          std::min(height, box.bottom + 1)};
}

constexpr std::array<std::array<int, 2>, 4> kNeighbours = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

struct Beside {
  float z_m;         // the neighbour across the largest step; the pixel's own depth without one
  bool person_near;  // the person is at this pixel or at a neighbour
};

Beside look_beside(const BodyLayer& layer, const Image<float>& plate_z_m, int x, int y) {
  const float here = nearest_z(layer, plate_z_m, x, y);
  Beside beside{here, body_in_front(layer, plate_z_m, x, y)};
  for (const auto& [dx, dy] : kNeighbours) {
    const int nx = x + dx;
    const int ny = y + dy;
    if (nx < 0 || ny < 0 || nx >= plate_z_m.width() || ny >= plate_z_m.height()) continue;
    beside.person_near = beside.person_near || body_in_front(layer, plate_z_m, nx, ny);
    const float there = nearest_z(layer, plate_z_m, nx, ny);
    const bool larger = std::abs(there - here) > std::abs(beside.z_m - here);
    if (is_depth_step(here, there) && larger) beside.z_m = there;
  }
  return beside;
}

/// The person has no shadows; parts that face down or sit low get less of the ceiling's light.
Vector3f body_light(const Room& room, const BodyPoint& point) {
  const LitPoint at{point.position_m, point.normal};
  const float height = std::clamp(point.position_m.y() / 1.8F, 0.0F, 1.0F);
  const float rim = std::clamp(point.facing, 0.0F, 1.0F);  // folds darken towards the outline
  Vector3f light = ambient_light(room, at, (0.45F + 0.45F * height) * (0.65F + 0.35F * rim));
  for (const Light& lamp : room.lights) light += light_from(lamp, at);
  return light;
}

Vector3f body_srgb(const WalkingBody& body, const BodyLayer& layer, const PlacedCamera& camera,
                   const Room& room, const ClothAtlas& clothes, int x, int y) {
  const BodyPart& part = body.parts()[layer.part().at(x, y)];
  const BodyPoint point = body_point(part, camera, x, y, layer.z_m().at(x, y));
  const Vector3f albedo = clothes.at(part.garment, point.cloth_m);
  return srgb_from_linear(albedo.cwiseProduct(body_light(room, point)));
}

/// Share of a pixel that the person covers, from how many of its neighbours they cover too.
float coverage(const BodyLayer& layer, const Image<float>& plate_z_m, int x, int y) {
  float covered = 0.5F;
  for (const auto& [dx, dy] : kNeighbours) {
    const int nx = std::clamp(x + dx, 0, plate_z_m.width() - 1);
    const int ny = std::clamp(y + dy, 0, plate_z_m.height() - 1);
    if (body_in_front(layer, plate_z_m, nx, ny)) covered += 0.125F;
  }
  return covered;
}

struct Ball {
  Vector3f centre_m;
  float radius_m;
};

/// The balls at the ends of the low limbs: what takes light away from the floor.
int low_balls(const WalkingBody& body, std::array<Ball, 2U * WalkingBody::kMaxParts>& balls) {
  constexpr float kLow_m = 0.5F;
  std::size_t count = 0;
  for (const BodyPart& part : body.parts()) {
    const Vector3f first = part.world_from_local.translation();
    const Vector3f second = part.world_from_local * Vector3f(0, part.shape.length(), 0);
    if (first.y() < kLow_m) balls[count++] = {first, part.shape.first_radius()};
    if (second.y() < kLow_m) balls[count++] = {second, part.shape.second_radius()};
  }
  return static_cast<int>(count);
}

/// Share of the light from above that the balls leave for a point of the floor.
float light_left(std::span<const Ball> balls, const Vector3f& floor_m) {
  float taken = 0.0F;
  for (const Ball& ball : balls) {
    const Vector3f way = ball.centre_m - floor_m;
    const float squared = std::max(way.squaredNorm(), ball.radius_m * ball.radius_m);
    taken += std::max(0.0F, way.y()) / std::sqrt(squared) * ball.radius_m * ball.radius_m / squared;
  }
  return 1.0F - 0.75F * std::min(1.0F, 0.8F * taken);
}

}  // namespace

void put_body_depth(const BodyLayer& layer, const DepthPlate& plate,
                    ImageView<std::uint16_t> depth_mm) {
  const PixelBox& box = layer.box();
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      if (!body_in_front(layer, plate.z_m, x, y)) continue;
      depth_mm.at(x, y) = static_cast<std::uint16_t>(1000.0F * layer.z_m().at(x, y) + 0.5F);
    }
  }
}

void put_noisy_body_depth(const WalkingBody& body, const BodyLayer& layer,
                          const PlacedCamera& camera, const DepthPlate& plate,
                          const Clothes& clothes, const DepthNoise& noise, std::uint32_t key,
                          ImageView<std::uint16_t> depth_mm) {
  if (layer.box().empty()) return;
  const PixelBox box = grown(layer.box(), depth_mm.width, depth_mm.height);
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const Beside beside = look_beside(layer, plate.z_m, x, y);
      if (!beside.person_near) continue;
      PerfectReading reading{plate.z_m.at(x, y), plate.facing.at(x, y), plate.infrared.at(x, y),
                             beside.z_m};
      if (body_in_front(layer, plate.z_m, x, y)) {
        const BodyPart& part = body.parts()[layer.part().at(x, y)];
        reading.z_m = layer.z_m().at(x, y);
        reading.facing = body_point(part, camera, x, y, reading.z_m).facing;
        reading.infrared = worn(clothes, part.garment).infrared;
      }
      const auto pixel = static_cast<std::uint32_t>(y * depth_mm.width + x);
      depth_mm.at(x, y) = noise.read(reading, key, pixel);
    }
  }
}

void put_floor_shade(const WalkingBody& body, const PlacedCamera& camera, const ColorPlate& plate,
                     ImageView<Rgb8> color) {
  constexpr float kReach_m = 0.6F;
  constexpr float kFloor_m = 0.03F;  // rugs too
  std::array<Ball, 2U * WalkingBody::kMaxParts> all_balls;
  const std::span<const Ball> balls(all_balls.data(),
                                    static_cast<std::size_t>(low_balls(body, all_balls)));
  const Eigen::Affine3f at(Eigen::Translation3f{body.floor_point_m()});
  const PixelBox box =
      camera.pixels_of_box(at, {-kReach_m, 0, -kReach_m}, {kReach_m, kFloor_m, kReach_m});
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const Vector3f point = camera.point(x, y, plate.z_m.at(x, y));
      const float away_m = (point - body.floor_point_m()).norm();
      if (point.y() > kFloor_m || away_m > kReach_m) continue;
      const float fade = std::clamp(2.0F - 2.0F * away_m / kReach_m, 0.0F, 1.0F);
      const float left = 1.0F - fade * (1.0F - std::sqrt(light_left(balls, point)));
      Rgb8& pixel = color.at(x, y);
      pixel = {static_cast<std::uint8_t>(static_cast<float>(pixel.r) * left),
               static_cast<std::uint8_t>(static_cast<float>(pixel.g) * left),
               static_cast<std::uint8_t>(static_cast<float>(pixel.b) * left)};
    }
  }
}

void put_body_color(const WalkingBody& body, const BodyLayer& layer, const PlacedCamera& camera,
                    const ColorPlate& plate, const Room& room, const ClothAtlas& clothes,
                    ImageView<Rgb8> color) {
  const PixelBox& box = layer.box();
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      if (!body_in_front(layer, plate.z_m, x, y)) continue;
      const Vector3f srgb = body_srgb(body, layer, camera, room, clothes, x, y);
      const float share = coverage(layer, plate.z_m, x, y);
      Rgb8& pixel = color.at(x, y);
      const Vector3f behind(pixel.r, pixel.g, pixel.b);
      const Vector3f mixed = behind + share * (srgb - behind) + Vector3f::Constant(0.5F);
      pixel = {static_cast<std::uint8_t>(mixed.x()), static_cast<std::uint8_t>(mixed.y()),
               static_cast<std::uint8_t>(mixed.z())};
    }
  }
}

}  // namespace roomcast::sim
