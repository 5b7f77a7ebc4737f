// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/stands.h"

#include <algorithm>

namespace roomcast::sim {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

/// At a share of the room's half size from its middle, as near to the wall as a bracket allows.
SensorStand stand_at(const Vector3f& room_size_m, const Vector2f& share, float height_m,
                     const Vector2f& looks_past_middle_m, Dice& dice) {
  const float bracket_m = dice.between(0.30F, 0.38F);
  const Vector2f half =
      0.5F * Vector2f(room_size_m.x(), room_size_m.z()) - Vector2f::Constant(bracket_m);
  SensorStand stand;
  stand.eye_m = {share.x() * half.x(), std::min(height_m, room_size_m.y() - 0.3F),
                 share.y() * half.y()};
  stand.target_m = {looks_past_middle_m.x() + dice.between(-0.2F, 0.2F), dice.between(0.7F, 0.9F),
                    looks_past_middle_m.y() + dice.between(-0.2F, 0.2F)};
  return stand;
}

}  // namespace

Stands draw_stands_around(const Vector3f& size, Dice& dice) {
  const auto mid = [&] { return dice.between(-0.15F, 0.15F); };
  return {stand_at(size, {-0.96F, -0.94F}, dice.between(1.8F, 2.0F), {0.45F, 0.30F}, dice),
          stand_at(size, {0.96F, -0.92F}, dice.between(1.7F, 1.9F), {-0.50F, 0.20F}, dice),
          stand_at(size, {mid(), 1.0F}, dice.between(2.0F, 2.15F), {0.1F, -0.55F}, dice),
          stand_at(size, {-0.94F, 0.96F}, dice.between(1.7F, 1.9F), {0.55F, -0.35F}, dice),
          stand_at(size, {0.95F, 0.95F}, dice.between(1.9F, 2.1F), {-0.35F, -0.20F}, dice),
          stand_at(size, {mid(), -1.0F}, dice.between(1.9F, 2.1F), {0.1F, 0.45F}, dice),
          stand_at(size, {-1.0F, mid()}, dice.between(2.0F, 2.15F), {0.4F, 0.0F}, dice),
          stand_at(size, {1.0F, mid()}, dice.between(1.9F, 2.1F), {-0.4F, 0.0F}, dice)};
}

Stands draw_stands_in_corners(const Vector3f& size, Dice& dice) {
  const auto high = [&] { return dice.between(1.9F, 2.1F); };
  const auto mid = [&] { return dice.between(-0.2F, 0.2F); };
  return {stand_at(size, {-1.0F, -1.0F}, high(), {0.35F, 0.30F}, dice),
          stand_at(size, {1.0F, -1.0F}, high(), {-0.35F, 0.30F}, dice),
          stand_at(size, {1.0F, 1.0F}, high(), {-0.35F, -0.30F}, dice),
          stand_at(size, {-1.0F, 1.0F}, high(), {0.35F, -0.30F}, dice),
          stand_at(size, {mid(), 1.0F}, high(), {0.0F, -0.5F}, dice),
          stand_at(size, {mid(), -1.0F}, high(), {0.0F, 0.5F}, dice),
          stand_at(size, {-1.0F, mid()}, high(), {0.5F, 0.0F}, dice),
          stand_at(size, {1.0F, mid()}, high(), {-0.5F, 0.0F}, dice)};
}

Stands draw_stands_on_tripods(const Vector3f& size, Dice& dice) {
  Stands stands = draw_stands_around(size, dice);
  const std::array<Vector2f, kTripods> places_m = {Vector2f(0, 2.25F), Vector2f(2.3F, 0.2F),
                                                   Vector2f(-2.3F, 0.2F), Vector2f(0, -2.2F)};
  for (std::size_t i = 0; i < places_m.size(); ++i) {
    const Vector2f at =
        places_m[i] + Vector2f(dice.between(-0.1F, 0.1F), dice.between(-0.1F, 0.1F));
    stands[i].eye_m = {at.x(), dice.between(1.35F, 1.65F), at.y()};
    stands[i].target_m = {dice.between(-0.1F, 0.1F), dice.between(0.85F, 0.95F),
                          dice.between(-0.1F, 0.1F)};
  }
  return stands;
}

}  // namespace roomcast::sim
