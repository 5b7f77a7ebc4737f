// SPDX-License-Identifier: Apache-2.0
// Furniture of workplaces, and objects on walls and ceilings.
#include <algorithm>
#include <array>
#include <cmath>

#include "roomcast/simulator/scene/furnisher.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::AngleAxisf;
using Eigen::Translation3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

}  // namespace

void Furnisher::monitor_and_keyboard(const Affine3f& on_top) {
  Surface shown =
      glazed(painted(Pattern::kScreen, 0xe8ecf0, 0x2a4a6a, 0x1c2430, random_.seed(), 0.04F));
  shown.size_m = {0.54F, 0.31F};
  shown.glow = 0.7F;
  add_monitor(room_, moved(on_top, {0, 0, -0.20F}, random_.between(-0.15F, 0.15F)), palette_.dark,
              shown);
  add_keyboard(room_, moved(on_top, {0, 0, 0.16F}), random_.seed());
}

Furnisher::Place Furnisher::desk(bool pulled_up, float front_m) {
  const float width = random_.between(1.3F, 1.6F);
  const auto all = plan_.against_wall({width, 1.25F, 1.50F}, front_m);
  if (!all) return all;
  const Affine3f at = moved(*all, {0, 0, -0.37F});
  add_table(room_, at, palette_.wood, {width, 0.73F, 0.75F});
  add_drawers(room_, moved(at, {0.5F * width - 0.35F, 0, -0.05F}), palette_.white, palette_.dark,
              {0.42F, 0.58F, 0.55F});
  const Affine3f top = moved(at, {-0.12F, 0.73F, 0});
  monitor_and_keyboard(top);
  add_mug(room_, moved(at, {-0.5F * width + 0.15F, 0.73F, 0.1F}), palette_.other_cloth);
  add_book_stack(room_, moved(at, {0.5F * width - 0.28F, 0.73F, -0.05F}), 1 + random_.below(3),
                 random_.seed());
  const float out = pulled_up ? 0.52F : 0.62F;
  const float turn = pulled_up ? 3.1416F : random_.between(1.2F, 5.0F);
  add_office_chair(room_, moved(at, {-0.12F, 0, out}, turn), palette_.cloth, palette_.dark);
  return at;
}

Furnisher::Place Furnisher::rack() {
  const Vector3f size(0.6F, random_.between(1.5F, 2.0F), 0.7F);
  const auto at = plan_.against_wall(size + Vector3f(0, 0.03F, 0.14F), 0.35F);
  if (at) add_rack(room_, moved(*at, {0, 0, -0.06F}), palette_.dark, size, random_.seed());
  return at;
}

Furnisher::Place Furnisher::lab_bench(float front_m, bool equipped) {
  const Vector3f size(random_.between(1.5F, 1.9F), 0.90F, 0.72F);
  const bool shelf = equipped;
  const auto at = plan_.against_wall(size + Vector3f(0, shelf ? 0.70F : 0.45F, 0), front_m);
  if (!at) return at;
  add_lab_bench(room_, *at, palette_.white, palette_.metal, size, shelf);
  add_drawers(room_, moved(*at, {0.5F * size.x() - 0.33F, 0, -0.02F}), palette_.metal,
              palette_.dark, {0.42F, 0.78F, 0.55F});
  // Left of the centre stays free for objects that people bring.
  const float right = 0.5F * size.x();
  add_instrument(room_, moved(*at, {right - 0.26F, size.y(), -0.08F}, -0.1F), {0.38F, 0.18F, 0.30F},
                 random_.seed());
  add_cable_coil(room_, moved(*at, {right - 0.62F, size.y(), 0.16F}), palette_.other_cloth, 0.09F);
  add_stool(room_, moved(*at, {right - 0.75F, 0, 0.02F}), palette_.metal, palette_.dark_wood);
  if (!equipped) return at;
  const float left = -right;
  add_instrument(room_, moved(*at, {left + 0.30F, size.y(), -0.10F}, 0.1F), {0.42F, 0.20F, 0.34F},
                 random_.seed());
  add_instrument(room_, moved(*at, {left + 0.80F, size.y(), -0.12F}, -0.08F), {0.30F, 0.24F, 0.34F},
                 random_.seed());
  const float shelf_y = size.y() + 0.465F;
  add_book_row(room_, moved(*at, {left + 0.10F, shelf_y, -0.10F}), 0.5F, 0.28F, random_.seed());
  add_instrument(room_, moved(*at, {0.25F * size.x(), shelf_y, -0.20F}), {0.34F, 0.14F, 0.26F},
                 random_.seed());
  return at;
}

Furnisher::Place Furnisher::cabinet() {
  const Vector3f size(random_.between(0.8F, 1.2F), random_.between(1.1F, 1.9F), 0.45F);
  const auto at = plan_.against_wall(size + Vector3f(0, 0.35F, 0), 0.3F);
  if (!at) return at;
  add_sideboard(room_, *at, palette_.metal, palette_.dark, size);
  const auto carton =
      room_.add(painted(Pattern::kDrawings, 0xb08a5a, 0x4a3018, 0x7a2a2a, random_.seed()));
  add_box(room_.mesh, carton, moved(*at, {-0.12F, size.y(), 0}, 0.15F), {-0.2F, 0, -0.14F},
          {0.2F, 0.24F, 0.14F});
  return at;
}

void Furnisher::window(int wall) {
  Surface view = painted(Pattern::kGarden, 0x2f5a26, 0x86a850, 0, random_.seed(), 0.0F);
  view.size_m = {random_.between(1.1F, 1.7F), random_.between(1.1F, 1.3F)};
  view.glow = 1.0F;
  const float middle = 1.55F;
  const auto at = plan_.on_wall_at({view.size_m.x() + 0.95F, view.size_m.y() + 0.95F, 0.17F},
                                   middle - 0.18F, wall);
  if (!at) return;
  const Affine3f centre = moved(*at, {0, 0.18F, 0});
  add_window(room_, centre, palette_.white, view, palette_.other_cloth);
  const Vector3f out = centre.linear().col(2);
  room_.lights.push_back({centre * Vector3f(0, 0.05F, 0.15F),
                          {2.6F, 2.9F, 3.4F},
                          Vector3f(out.x(), -0.1F, out.z()),
                          0.5F});
  const Affine3f foot = moved(centre, {0, -middle, 0});
  const float width = view.size_m.x() - 0.15F;
  if (plan_.take(moved(foot, {0, 0, 0.09F}), {width + 0.1F, 0.72F, 0.14F}))
    add_radiator(room_, foot, palette_.white, width);
}

void Furnisher::door() {
  const auto at = plan_.on_wall_at({1.06F, 2.12F, 0.08F}, 1.06F);
  if (!at) return;
  const Affine3f foot = moved(*at, {0, -1.06F, 0});
  plan_.keep_way({(foot * Vector3f(0, 0, 0.3F)).x(), (foot * Vector3f(0, 0, 0.3F)).z()},
                 {(foot * Vector3f(0, 0, 0.6F)).x(), (foot * Vector3f(0, 0, 0.6F)).z()}, 0.35F);
  const bool light = random_.chance(0.5F);
  const auto leaf = room_.add(painted(Pattern::kWood, light ? 0xe4dccb : 0xa87a4a,
                                      light ? 0xd2c7b0 : 0x825a30, 0, random_.seed()));
  add_door(room_, foot, leaf, palette_.metal);
}

void Furnisher::picture_on(const Affine3f& at, const Vector2f& size_m) {
  constexpr std::array<std::array<std::uint32_t, 2>, 5> kTones = {{{0x4a7a68, 0x1d3026},
                                                                   {0xe6dcc8, 0x2a2a2a},
                                                                   {0x7a5a3a, 0x2f2418},
                                                                   {0x24476b, 0x2a2a2a},
                                                                   {0xd9cfb8, 0x3a2a2a}}};
  const auto& tones = random_.one_of(kTones);
  const bool poster = random_.chance(0.3F);
  Surface picture = painted(poster ? Pattern::kPoster : Pattern::kPainting, tones[0], tones[1],
                            0x202020, random_.seed());
  if (poster) picture.base = linear_from_srgb(0xf0ece0);
  picture.size_m = size_m;
  if (!poster) picture = glazed(picture);
  add_picture(room_, at, random_.chance(0.5F) ? palette_.dark_wood : palette_.dark, picture);
}

void Furnisher::pictures(int count) {
  for (int i = 0; i < count; ++i) {
    const bool wide = random_.chance(0.5F);
    const float large = random_.between(0.45F, 1.2F);
    const Vector2f size =
        wide ? Vector2f(large, 0.62F * large) : Vector2f(0.6F * large, 0.8F * large);
    const float height = random_.between(1.45F, 1.7F);
    const auto at = plan_.on_wall_at({size.x() + 0.1F, size.y() + 0.1F, 0.04F}, height);
    if (at) picture_on(*at, size);
  }
}

void Furnisher::clock() {
  const auto at = plan_.on_wall_at({0.36F, 0.36F, 0.05F}, random_.between(1.85F, 2.05F));
  const Surface dial = room_.surfaces[palette_.white];
  if (at) add_clock(room_, *at, palette_.dark, dial);
}

Furnisher::Place Furnisher::whiteboard(float front_m) {
  const Vector2f size(random_.between(1.5F, 2.0F), 1.1F);
  const auto at = plan_.on_wall_at({size.x() + 0.1F, size.y() + 0.2F, 0.09F}, 1.50F);
  if (!at) return at;
  add_whiteboard(room_, *at, palette_.metal, size, random_.seed());
  const Vector3f near = *at * Vector3f(-0.4F, 0, 0.35F), far = *at * Vector3f(0.4F, 0, 0.35F);
  if (front_m > 0) plan_.keep_way({near.x(), near.z()}, {far.x(), far.z()}, front_m);
  return at;
}

Furnisher::Place Furnisher::wall_screen() {
  const auto at = plan_.on_wall_at({1.5F, 0.95F, 0.1F}, 1.55F);
  if (at) add_wall_screen(room_, *at, palette_.dark, {1.35F, 0.78F}, random_.seed());
  return at;
}

void Furnisher::pendant() {
  const Vector3f at(random_.between(-0.3F, 0.3F), room_.size_m.y(), random_.between(-0.3F, 0.3F));
  add_pendant_lamp(room_, at, palette_.metal, palette_.lampshade);
  room_.lights.push_back({at - Vector3f(0, 0.55F, 0), {4.2F, 3.8F, 3.1F}, {0, -1, 0}, 0.14F});
}

void Furnisher::panels() {
  Surface glowing = painted(Pattern::kFlat, 0xfff8ec, 0, 0, random_.seed());
  glowing.glow = 1.0F;
  const auto panel = room_.add(glowing);
  const float y = room_.size_m.y();
  for (const float share : {-0.22F, 0.22F}) {
    const float x = share * room_.size_m.x();
    add_box(room_.mesh, palette_.metal, Affine3f::Identity(), {x - 0.62F, y - 0.03F, -0.32F},
            {x + 0.62F, y - 0.001F, 0.32F});
    add_box(room_.mesh, panel, Affine3f::Identity(), {x - 0.6F, y - 0.034F, -0.3F},
            {x + 0.6F, y - 0.02F, 0.3F});
    room_.lights.push_back({{x, y - 0.06F, 0}, {3.6F, 3.5F, 3.3F}, {0, -1, 0}, 0.4F});
  }
}

}  // namespace roomcast::simulator
