// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/floor_shade.h"

#include <algorithm>
#include <cmath>

#include "roomcast/simulator/tracing/lighting.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kReach_m = 1.1F;   // beyond the balls
constexpr float kUnseen = 0.997F;  // shading below one grey level is ignored

float brightness(const Vector3f& light) {
  return light.sum() / 3.0F;
}

/// Share of the sky above a floor point that a ball hides.
float sky_hidden(const ShadeBall& ball, const Vector3f& floor_m) {
  const Vector3f way = ball.centre_m - floor_m;
  const float squared = std::max(way.squaredNorm(), ball.radius_m * ball.radius_m);
  return std::max(0.0F, way.y()) / std::sqrt(squared) * ball.radius_m * ball.radius_m / squared;
}

/// Direction and distance from a floor point to a lamp.
struct WayToLamp {
  Vector3f towards;
  float distance_m;
  float blur;  // blur of a shadow's edge, per metre between the ball and the point
};

WayToLamp way_to(const Light& lamp, const Vector3f& floor_m) {
  const Vector3f way = lamp.position_m - floor_m;
  const float distance = way.norm();
  return {way / distance, distance, lamp.radius_m / distance};
}

/// Share of a lamp that a ball hides from a point, from the distance between the ray and the ball's
/// rim.
float lamp_hidden(const ShadeBall& ball, const Vector3f& floor_m, const WayToLamp& lamp) {
  const Vector3f way = ball.centre_m - floor_m;
  const float along = way.dot(lamp.towards);
  if (along <= 0.0F || along >= lamp.distance_m) return 0.0F;
  const float blur = std::max(0.02F, lamp.blur * along);
  const float squared = way.squaredNorm() - along * along;
  const float reach = ball.radius_m + blur;
  if (squared >= reach * reach) return 0.0F;
  const float beside = std::sqrt(std::max(0.0F, squared));
  return std::clamp(0.5F + 0.5F * (ball.radius_m - beside) / blur, 0.0F, 1.0F);
}

float light_left_at(std::span<const ShadeBall> balls, const Room& room, const Vector3f& floor_m) {
  const LitPoint at{floor_m, Vector3f::UnitY()};
  const float ambient = brightness(ambient_light(room, at, 1.0F));
  float hidden_sky = 0.0F;
  for (const ShadeBall& ball : balls) hidden_sky += sky_hidden(ball, floor_m);
  float all = ambient;
  float left = ambient * (1.0F - std::min(0.75F, 0.7F * hidden_sky));
  for (const Light& lamp : room.lights) {
    const float light = brightness(light_from(lamp, at));
    const WayToLamp way = way_to(lamp, floor_m);
    float open = 1.0F;
    for (const ShadeBall& ball : balls)
      open = std::min(open, 1.0F - lamp_hidden(ball, floor_m, way));
    all += light;
    left += open * light;
  }
  return left / all;
}

}  // namespace

void FloorShade::work_out(std::span<const ShadeBall> balls, const Room& room) {
  area_.setEmpty();
  if (balls.empty()) return;
  map_.setEmpty();
  for (const ShadeBall& ball : balls) {
    const Vector2f at(ball.centre_m.x(), ball.centre_m.z());
    map_.extend(Vector2f(at.array() - kReach_m));
    map_.extend(Vector2f(at.array() + kReach_m));
  }
  const Vector2f half(0.5F * room.size_m.x(), 0.5F * room.size_m.z());
  map_ = map_.intersection(Eigen::AlignedBox2f(-half, half));
  const Vector2f size = map_.sizes() / kCell_m;
  const int width = std::max(2, static_cast<int>(std::ceil(size.x())) + 1);
  const int height = std::max(2, static_cast<int>(std::ceil(size.y())) + 1);
  left_.resize(width, height);
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const Vector2f at =
          map_.min() + kCell_m * Vector2f(static_cast<float>(i), static_cast<float>(j));
      // Display values are approximately the square root of light.
      const float left = std::sqrt(light_left_at(balls, room, {at.x(), 0.0F, at.y()}));
      left_.at(i, j) = left;
      if (left > kUnseen) continue;
      area_.extend(Vector2f(at.array() - kCell_m));
      area_.extend(Vector2f(at.array() + kCell_m));
    }
  }
  if (!area_.isEmpty()) area_ = area_.intersection(map_);
}

}  // namespace roomcast::simulator
