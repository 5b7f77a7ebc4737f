// SPDX-License-Identifier: Apache-2.0
// Furniture of living rooms.
#include <algorithm>
#include <array>
#include <cmath>

#include "roomcast/simulator/scene/angles.h"
#include "roomcast/simulator/scene/furnisher.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::AngleAxisf;
using Eigen::Translation3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

}  // namespace

Seat seat_of_sofa(const Affine3f& sofa, float along_m) {
  Seat seat;
  seat.seat_m = sofa * Vector3f(along_m, 0.485F, 0.06F);
  const Vector3f stand = sofa * Vector3f(along_m, 0, 0.53F);
  seat.stand_m = {stand.x(), stand.z()};
  const Vector3f front = sofa.linear().col(2);
  seat.heading_rad = std::atan2(front.x(), front.z());
  return seat;
}

Seat seat_of_chair(const Affine3f& chair, float height_m) {
  Seat seat;
  seat.seat_m = chair * Vector3f(0, height_m, -0.02F);
  const Vector3f stand = chair * Vector3f(0, 0, 0.42F);
  seat.stand_m = {stand.x(), stand.z()};
  const Vector3f front = chair.linear().col(2);
  seat.heading_rad = std::atan2(front.x(), front.z());
  return seat;
}

Furnisher::Place Furnisher::sofa(float front_m) {
  const float width = random_.chance(0.5F) ? 2.1F : 1.6F;
  const auto at = plan_.against_wall({width, 0.92F, 0.90F}, front_m);
  if (!at) return at;
  add_sofa(room_, *at, palette_.cloth, palette_.dark_wood, width);
  const auto pillow =
      room_.add(painted(random_.chance(0.5F) ? Pattern::kPlaid : Pattern::kWallpaper, 0xd8a13a,
                        0x8c2f2b, 0xf0e4c8, random_.seed()));
  add_throw_cushion(room_, *at, pillow, {-0.29F * width, 0.67F, 0.03F}, 0.42F);
  if (random_.chance(0.6F))
    add_throw_cushion(room_, *at, palette_.other_cloth, {0.30F * width, 0.67F, 0.02F}, -0.40F);
  return at;
}

Furnisher::Place Furnisher::coffee_table_before(const Affine3f& sofa) {
  const bool round = random_.chance(0.4F);
  const Vector3f size = round ? Vector3f(0.8F, 0.44F, 0.8F) : Vector3f(1.05F, 0.42F, 0.56F);
  const float beside = random_.between(-0.3F, 0.3F);
  const Affine3f at = moved(sofa, {beside, 0, 1.30F});
  if (!plan_.take(at, size + Vector3f(0, 0.15F, 0))) return std::nullopt;
  if (round) {
    add_round_table(room_, at, palette_.wood, 0.4F, 0.44F);
  } else {
    add_table(room_, at, palette_.wood, size);
  }
  const Affine3f top = moved(at, {0, size.y(), 0});
  add_fruit_bowl(room_, moved(top, {0.17F, 0, 0.03F}), random_.seed());
  add_book_stack(room_, moved(top, {-0.19F, 0, -0.02F}), 2 + random_.below(3), random_.seed());
  return at;
}

void Furnisher::rug_under(const Vector2f& middle_m, const Vector2f& size_m) {
  constexpr std::array<std::array<std::uint32_t, 3>, 4> kRugs = {{{0x7a2a2a, 0x23364f, 0xd8c49a},
                                                                  {0x2f4f5f, 0x7a3a2a, 0xe0d0a8},
                                                                  {0x4a5a3a, 0x8a6a30, 0xe8dcc0},
                                                                  {0x5a3a5a, 0x2a3a5a, 0xd8b8a0}}};
  const auto& tones = random_.one_of(kRugs);
  Surface rug = painted(Pattern::kRug, tones[0], tones[1], tones[2], random_.seed());
  rug.size_m = size_m;
  const Vector2f half = 0.5F * Vector2f(room_.size_m.x(), room_.size_m.z()) -
                        Vector2f::Constant(0.08F) - 0.5F * size_m;
  const Vector2f at = middle_m.cwiseMax(-half).cwiseMin(half) - 0.5F * size_m;
  add_quad(room_.mesh, room_.add(rug), Affine3f::Identity(), {at.x(), 0.008F, at.y() + size_m.y()},
           {size_m.x(), 0, 0}, {0, 0, -size_m.y()});
}

Furnisher::Place Furnisher::dining_table() {
  const bool round = random_.chance(0.5F);
  const float radius = random_.between(0.45F, 0.58F);
  const Vector3f top = round ? Vector3f(2.0F * radius, 0.74F, 2.0F * radius)
                             : Vector3f(random_.between(1.1F, 1.5F), 0.74F, 0.8F);
  const Vector3f all = top + Vector3f(round ? 0.75F : 0.1F, 0.25F, 0.75F);
  auto at = plan_.in_the_open(all);
  if (!at) return at;
  if (round) {
    add_round_table(room_, *at, palette_.wood, radius, 0.74F);
  } else {
    add_table(room_, *at, palette_.wood, top);
  }
  const bool shells = random_.chance(0.4F);
  const auto chair = [&](const Affine3f& place) {
    if (shells) {
      add_shell_chair(room_, place, palette_.other_cloth, palette_.metal);
    } else {
      add_chair(room_, place, palette_.dark_wood, palette_.other_cloth);
    }
  };
  if (round) {
    const int count = 3 + random_.below(2);
    for (int i = 0; i < count; ++i) {
      const float yaw = 2.0F * kPi * (static_cast<float>(i) + random_.between(-0.06F, 0.06F)) /
                        static_cast<float>(count);
      chair(moved(moved(*at, Vector3f::Zero(), yaw), {0, 0, -radius - 0.10F}));
    }
  } else {
    for (const float x : {-0.25F, 0.25F}) {
      for (const float z : {-1.0F, 1.0F}) {
        const float away = 0.5F * top.z() + random_.between(0.05F, 0.11F);
        chair(moved(*at, {x * top.x(), 0, -z * away},
                    (z > 0 ? 0.0F : kPi) + random_.between(-0.15F, 0.15F)));
      }
    }
  }
  set_out(moved(*at, {0, 0.74F, 0}), {0.7F * top.x(), 0.7F * top.z()}, 4);
  return at;
}

Furnisher::Place Furnisher::television() {
  const float width = random_.between(1.4F, 1.8F);
  const auto at = plan_.against_wall({width, 1.30F, 0.42F}, 0.5F);
  if (!at) return at;
  add_sideboard(room_, *at, palette_.wood, palette_.dark, {width, 0.50F, 0.42F});
  const auto glass =
      room_.add(glazed(painted(Pattern::kPlain, 0x101114, 0, 0, random_.seed(), 0.03F)));
  const Affine3f top = moved(*at, {random_.between(-0.12F, 0.12F), 0.50F, -0.03F});
  add_box(room_.mesh, glass, top, {-0.20F, 0, -0.08F}, {0.20F, 0.02F, 0.10F});
  add_box(room_.mesh, glass, top, {-0.04F, 0.02F, -0.035F}, {0.04F, 0.10F, -0.02F});
  add_box(room_.mesh, glass, top, {-0.52F, 0.08F, -0.02F}, {0.52F, 0.70F, 0.02F});
  return at;
}

Furnisher::Place Furnisher::sideboard() {
  const Vector3f size(random_.between(1.1F, 1.7F), random_.between(0.62F, 0.85F), 0.42F);
  const auto at = plan_.against_wall(size + Vector3f(0, 0.40F, 0), 0.3F);
  if (!at) return at;
  add_sideboard(room_, *at, palette_.wood, palette_.metal, size);
  const Affine3f top = moved(*at, {0, size.y(), 0});
  add_table_lamp(room_, moved(top, {0.34F * size.x(), 0, -0.02F}), palette_.dark_wood,
                 palette_.lampshade);
  add_book_row(room_, moved(top, {-0.45F * size.x(), 0, 0.12F}), 0.3F * size.x(), 0.28F,
               random_.seed());
  add_fruit_bowl(room_, moved(top, {0.06F * size.x(), 0, 0.0F}), random_.seed());
  return at;
}

Furnisher::Place Furnisher::bookshelf(float front_m) {
  const Vector3f size(random_.between(0.8F, 1.3F),
                      random_.chance(0.7F) ? random_.between(1.6F, 2.0F) : 0.95F, 0.30F);
  const auto at = plan_.against_wall(size, front_m);
  if (at) add_bookshelf(room_, *at, palette_.wood, size, random_.seed());
  return at;
}

Furnisher::Place Furnisher::wardrobe() {
  const Vector3f size(random_.between(0.9F, 1.4F), random_.between(1.85F, 2.1F), 0.58F);
  const auto at = plan_.in_corner(size);
  if (at) add_sideboard(room_, *at, palette_.dark_wood, palette_.metal, size);
  return at;
}

Furnisher::Place Furnisher::armchair() {
  const auto at = plan_.in_the_open({1.0F, 0.9F, 1.0F});
  if (at) add_sofa(room_, *at, palette_.other_cloth, palette_.dark_wood, 0.94F);
  return at;
}

void Furnisher::plant() {
  const auto at = plan_.in_corner({0.78F, 1.35F, 0.78F});
  if (at) add_plant(room_, *at, random_.seed());
}

void Furnisher::floor_lamp() {
  const auto at = plan_.in_corner({0.46F, 1.58F, 0.46F});
  if (!at) return;
  add_floor_lamp(room_, *at, palette_.metal, palette_.lampshade);
  const Vector3f bulb = *at * Vector3f(0, 1.48F, 0);
  room_.lights.push_back({bulb, {0.7F, 0.55F, 0.33F}, Vector3f::Zero(), 0.12F});
}

void Furnisher::odd_end(int which) {
  switch (which) {
    case 0: {
      const auto at = plan_.in_corner({0.55F, 0.5F, 0.45F});
      if (!at) return;
      const auto carton =
          room_.add(painted(Pattern::kDrawings, 0xb08a5a, 0x4a3018, 0x7a2a2a, random_.seed()));
      add_box(room_.mesh, carton, *at, {-0.24F, 0, -0.2F}, {0.24F, 0.30F, 0.2F});
      add_box(room_.mesh, carton, moved(*at, {0.02F, 0.30F, 0}, 0.2F), {-0.16F, 0, -0.13F},
              {0.16F, 0.20F, 0.13F});
      return;
    }
    case 1: {
      const auto at = plan_.in_the_open({0.46F, 0.48F, 0.46F});
      if (at) add_stool(room_, *at, palette_.dark_wood, palette_.wood);
      return;
    }
    case 2: {
      const auto at = plan_.in_corner({0.26F, 0.26F, 0.26F});
      if (!at) return;
      const auto ball =
          room_.add(painted(Pattern::kPlaid, 0xd83a2a, 0xf0e4c8, 0x2a4a8c, random_.seed()));
      add_cushion(room_.mesh, ball, *at, {0, 0.12F, 0}, Vector3f::Constant(0.12F), 1.0F);
      return;
    }
    case 3: {
      const auto at = plan_.in_corner({0.34F, 0.36F, 0.34F});
      if (at) add_bin(room_, *at, palette_.dark);
      return;
    }
    default: {
      const auto at = plan_.against_wall({1.75F, 1.05F, 0.52F}, 0.0F);
      if (at) add_bicycle(room_, *at, random_.seed());
    }
  }
}

void Furnisher::odds_and_ends(int count) {
  for (int i = 0; i < count; ++i) odd_end(random_.below(5));
}

void Furnisher::set_out(const Affine3f& on_top, const Vector2f& size_m, int count) {
  constexpr std::array<std::uint32_t, 5> kGlazes = {0xb83a30, 0x2f6f5a, 0xf0ede4, 0x2a4a8c,
                                                    0xd07a2a};
  for (int i = 0; i < count; ++i) {  // next to each other, so that they do not overlap
    const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(count) - 0.5F;
    const Affine3f at =
        moved(on_top, {share * size_m.x(), 0, random_.between(-0.3F, 0.3F) * size_m.y()},
              random_.between(-0.4F, 0.4F));
    const auto glaze =
        room_.add(painted(Pattern::kPlain, random_.one_of(kGlazes), 0, 0, random_.seed()));
    switch (random_.below(4)) {
      case 0: {
        const std::array<Vector2f, 7> vase = {Vector2f(0, 0),  {0.045F, 0},     {0.075F, 0.09F},
                                              {0.035F, 0.18F}, {0.045F, 0.22F}, {0.028F, 0.19F},
                                              {0, 0.17F}};
        add_turned(room_.mesh, glaze, at, vase);
        break;
      }
      case 1:
        add_book_stack(room_, at, 1 + random_.below(2), random_.seed());
        break;
      case 2: {
        const std::array<Vector2f, 5> plate = {
            Vector2f(0, 0), {0.06F, 0}, {0.095F, 0.016F}, {0.088F, 0.017F}, {0, 0.005F}};
        add_turned(room_.mesh, glaze, at, plate);
        break;
      }
      default:
        add_mug(room_, at, glaze);
    }
  }
}

}  // namespace roomcast::simulator
