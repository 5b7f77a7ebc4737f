// SPDX-License-Identifier: Apache-2.0
// Objects on tables, and light furniture: round tables, stools, lamps, cups, books, laptops,
// bicycles.
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "roomcast/simulator/random/random.h"
#include "roomcast/simulator/scene/furniture.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::AngleAxisf;
using Eigen::Translation3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;

void add_ring(Room& room, const Affine3f& at, SurfaceIndex surface, const Vector3f& centre,
              float radius_m, float thickness_m) {
  constexpr int kSteps = 28;
  std::vector<Vector3f> line;
  for (int i = 0; i <= kSteps; ++i) {
    const float angle = kTurn * static_cast<float>(i) / static_cast<float>(kSteps);
    line.emplace_back(centre + radius_m * Vector3f(std::cos(angle), std::sin(angle), 0));
  }
  add_tube(room.mesh, surface, at, line, thickness_m);
}

}  // namespace

void add_round_table(Room& room, const Affine3f& at, SurfaceIndex wood, float radius_m,
                     float height_m) {
  const float h = height_m;
  const std::array<Vector2f, 11> foot = {Vector2f(0, 0),
                                         {0.55F * radius_m, 0},
                                         {0.52F * radius_m, 0.03F},
                                         {0.10F, 0.07F},
                                         {0.05F, 0.16F},
                                         {0.075F, 0.24F * h / 0.74F},
                                         {0.04F, 0.30F * h},
                                         {0.045F, 0.75F * h},
                                         {0.09F, h - 0.05F},
                                         {0.30F * radius_m, h - 0.035F},
                                         {0, h - 0.035F}};
  add_turned(room.mesh, wood, at, foot);
  const std::array<Vector2f, 6> top = {Vector2f(0, h - 0.034F), {radius_m - 0.015F, h - 0.034F},
                                       {radius_m, h - 0.022F},  {radius_m, h - 0.010F},
                                       {radius_m - 0.010F, h},  {0, h}};
  add_turned(room.mesh, wood, at, top);
}

void add_stool(Room& room, const Affine3f& at, SurfaceIndex wood, SurfaceIndex seat) {
  constexpr float kHeight_m = 0.46F;
  const std::array<Vector2f, 4> disc = {Vector2f(0, kHeight_m - 0.045F),
                                        {0.17F, kHeight_m - 0.045F},
                                        {0.18F, kHeight_m - 0.01F},
                                        {0, kHeight_m}};
  add_turned(room.mesh, seat, at, disc);
  for (int i = 0; i < 3; ++i) {
    const float angle = kTurn * static_cast<float>(i) / 3.0F;
    const Vector3f out(std::cos(angle), 0, std::sin(angle));
    const std::array<Vector3f, 2> leg = {Vector3f(0.21F * out),
                                         Vector3f(0.11F * out + Vector3f(0, kHeight_m - 0.03F, 0))};
    add_tube(room.mesh, wood, at, leg, 0.016F);
  }
}

void add_shell_chair(Room& room, const Affine3f& at, SurfaceIndex shell, SurfaceIndex metal) {
  add_cushion(room.mesh, shell, at, {0, 0.45F, 0.01F}, {0.22F, 0.022F, 0.21F}, 0.35F);
  const Affine3f back =
      at * Translation3f(0, 0.66F, -0.215F) * AngleAxisf(-0.16F, Vector3f::UnitX());
  add_cushion(room.mesh, shell, back, Vector3f::Zero(), {0.21F, 0.19F, 0.018F}, 0.4F);
  for (const float x : {-1.0F, 1.0F}) {
    const std::array<Vector3f, 4> side = {Vector3f(x * 0.20F, 0.0F, 0.20F),
                                          {x * 0.185F, 0.425F, 0.16F},
                                          {x * 0.185F, 0.425F, -0.17F},
                                          {x * 0.18F, 0.72F, -0.255F}};
    add_tube(room.mesh, metal, at, side, 0.011F);
    const std::array<Vector3f, 2> rear = {Vector3f(x * 0.20F, 0.0F, -0.21F),
                                          {x * 0.185F, 0.425F, -0.14F}};
    add_tube(room.mesh, metal, at, rear, 0.011F);
  }
}

void add_table_lamp(Room& room, const Affine3f& at, SurfaceIndex base, SurfaceIndex shade) {
  const std::array<Vector2f, 7> foot = {Vector2f(0, 0), {0.07F, 0},      {0.075F, 0.02F},
                                        {0.03F, 0.05F}, {0.055F, 0.14F}, {0.012F, 0.20F},
                                        {0.010F, 0.30F}};
  add_turned(room.mesh, base, at, foot);
  const std::array<Vector2f, 2> cone = {Vector2f(0.14F, 0.24F), {0.085F, 0.42F}};
  add_turned(room.mesh, shade, at, cone);
}

void add_mug(Room& room, const Affine3f& at, SurfaceIndex glaze) {
  const std::array<Vector2f, 6> cup = {Vector2f(0, 0),  {0.038F, 0},      {0.041F, 0.09F},
                                       {0.038F, 0.09F}, {0.035F, 0.012F}, {0, 0.012F}};
  add_turned(room.mesh, glaze, at, cup);
  const std::array<Vector3f, 5> handle = {Vector3f(0.038F, 0.075F, 0),
                                          {0.06F, 0.07F, 0},
                                          {0.066F, 0.045F, 0},
                                          {0.056F, 0.022F, 0},
                                          {0.037F, 0.02F, 0}};
  add_tube(room.mesh, glaze, at, handle, 0.005F);
}

void add_book_stack(Room& room, const Affine3f& at, int count, std::uint32_t seed) {
  constexpr std::array<std::uint32_t, 6> kCovers = {0x35546e, 0x8c2f2b, 0xc9a24a,
                                                    0x2f5d3a, 0xe6ddc8, 0x4a3555};
  Random random(seed);
  float y = 0.0F;
  for (int i = 0; i < count; ++i) {
    const Vector3f half(random.between(0.08F, 0.12F), random.between(0.008F, 0.02F),
                        random.between(0.11F, 0.15F));
    const auto cover = room.add(painted(Pattern::kPoster, random.one_of(kCovers),
                                        random.one_of(kCovers), 0x202020, random.seed()));
    room.surfaces.back().size_m = {2.0F * half.z(), 2.0F * half.x()};
    const Affine3f turned = at * AngleAxisf(random.between(-0.3F, 0.3F), Vector3f::UnitY());
    add_box(room.mesh, cover, turned, {-half.x(), y, -half.z()},
            {half.x(), y + 2.0F * half.y(), half.z()});
    y += 2.0F * half.y() + 0.001F;
  }
}

void add_fruit_bowl(Room& room, const Affine3f& at, std::uint32_t seed) {
  constexpr std::array<std::uint32_t, 4> kFruit = {0xc8402a, 0xe0a030, 0x7fa43a, 0xd8702a};
  constexpr std::array<std::uint32_t, 3> kGlaze = {0x2f5f8a, 0xe8e0d0, 0x8a4a3a};
  Random random(seed);
  const std::array<Vector2f, 7> bowl = {Vector2f(0, 0), {0.05F, 0},     {0.06F, 0.012F},
                                        {0.13F, 0.06F}, {0.15F, 0.09F}, {0.13F, 0.07F},
                                        {0, 0.02F}};
  add_turned(room.mesh, add_paint(room, random.one_of(kGlaze), random.seed()), at, bowl);
  for (int i = 0; i < 4; ++i) {
    const float angle = 0.25F * kTurn * static_cast<float>(i);
    add_cushion(room.mesh, add_paint(room, random.one_of(kFruit), random.seed()), at,
                {0.05F * std::cos(angle), 0.08F, 0.05F * std::sin(angle)},
                Vector3f::Constant(0.04F), 1.0F);
  }
}

void add_keyboard(Room& room, const Affine3f& at, std::uint32_t seed) {
  Random random(seed);
  const bool light = random.chance(0.4F);
  const auto body = add_paint(room, light ? 0xd8d8d4 : 0x26272a, random.seed(), 0.3F);
  Surface face = painted(Pattern::kKeys, light ? 0xb8b8b2 : 0x1a1b1d, light ? 0xeeeeea : 0x3a3b40,
                         light ? 0x303030 : 0xd0d0d0, random.seed(), 0.3F);
  add_box(room.mesh, body, at, {-0.22F, 0, -0.07F}, {0.22F, 0.018F, 0.07F});
  add_quad(room.mesh, room.add(face), at, {-0.21F, 0.0195F, 0.06F}, {0.42F, 0, 0}, {0, 0, -0.12F});
}

void add_laptop(Room& room, const Affine3f& at, std::uint32_t seed) {
  Random random(seed);
  const auto shell =
      add_paint(room, random.chance(0.5F) ? 0xa8abb0 : 0x2a2b2f, random.seed(), 0.35F);
  const auto deck =
      room.add(painted(Pattern::kKeys, 0x38393d, 0x202124, 0xc8c8c8, random.seed(), 0.2F));
  add_box(room.mesh, shell, at, {-0.165F, 0, -0.115F}, {0.165F, 0.016F, 0.115F});
  add_quad(room.mesh, deck, at, {-0.14F, 0.0172F, 0.02F}, {0.28F, 0, 0}, {0, 0, -0.11F});
  const Affine3f lid =
      at * Translation3f(0, 0.016F, -0.112F) * AngleAxisf(-0.30F, Vector3f::UnitX());
  add_box(room.mesh, shell, lid, {-0.165F, 0, -0.008F}, {0.165F, 0.225F, 0});
  Surface shown =
      glazed(painted(Pattern::kScreen, 0xe8ecf0, 0x2a4a6a, 0x1c2430, random.seed(), 0.04F));
  shown.size_m = {0.31F, 0.20F};
  shown.glow = 0.7F;
  add_quad(room.mesh, room.add(shown), lid, {-0.155F, 0.012F, 0.0015F}, {0.31F, 0, 0},
           {0, 0.20F, 0});
}

void add_bin(Room& room, const Affine3f& at, SurfaceIndex surface) {
  const std::array<Vector2f, 5> wall = {
      Vector2f(0, 0), {0.12F, 0}, {0.15F, 0.34F}, {0.14F, 0.34F}, {0, 0.02F}};
  add_turned(room.mesh, surface, at, wall);
}

void add_bicycle(Room& room, const Affine3f& at, std::uint32_t seed) {
  constexpr std::array<std::uint32_t, 4> kFrames = {0xa03028, 0x2a5a8a, 0x2f6a4a, 0xd0a040};
  Random random(seed);
  const auto frame = add_paint(room, random.one_of(kFrames), random.seed());
  const auto rubber = add_paint(room, 0x1c1c1e, random.seed(), 0.1F);
  const auto metal = add_paint(room, 0xb8bcc0, random.seed(), 0.4F);
  constexpr float kWheel_m = 0.33F;
  const Vector3f rear(-0.5F, kWheel_m + 0.017F, 0), front(0.52F, kWheel_m + 0.017F, 0);
  const Vector3f pedals(-0.06F, 0.29F, 0), seat(-0.22F, 0.80F, 0), head(0.34F, 0.78F, 0);
  for (const Vector3f& hub : {rear, front}) {
    add_ring(room, at, rubber, hub, kWheel_m, 0.017F);
    add_ring(room, at, metal, hub, kWheel_m - 0.022F, 0.007F);
    for (int i = 0; i < 12; ++i) {
      const float angle = kTurn * static_cast<float>(i) / 12.0F;
      const std::array<Vector3f, 2> spoke = {
          hub, Vector3f(hub + 0.31F * Vector3f(std::cos(angle), std::sin(angle), 0))};
      add_tube(room.mesh, metal, at, spoke, 0.0022F);
    }
  }
  const auto bar = [&](SurfaceIndex surface, const Vector3f& a, const Vector3f& b, float radius) {
    const std::array<Vector3f, 2> line = {a, b};
    add_tube(room.mesh, surface, at, line, radius);
  };
  bar(frame, pedals, seat, 0.015F);
  bar(frame, pedals, head + Vector3f(0.01F, -0.08F, 0), 0.018F);
  bar(frame, seat + Vector3f(0.01F, -0.06F, 0), head, 0.015F);
  bar(frame, rear, pedals, 0.010F);
  bar(frame, rear, seat + Vector3f(0, -0.05F, 0), 0.008F);
  bar(frame, front, head, 0.014F);
  bar(metal, head, head + Vector3f(-0.05F, 0.20F, 0), 0.012F);
  bar(metal, seat, seat + Vector3f(-0.03F, 0.14F, 0), 0.012F);
  bar(metal, head + Vector3f(-0.05F, 0.20F, -0.22F), head + Vector3f(-0.05F, 0.20F, 0.22F), 0.012F);
  for (const float z : {-0.20F, 0.20F})
    add_cushion(room.mesh, rubber, at, head + Vector3f(-0.05F, 0.20F, z), {0.018F, 0.018F, 0.05F},
                0.7F);
  add_cushion(room.mesh, rubber, at, seat + Vector3f(-0.03F, 0.16F, 0), {0.13F, 0.03F, 0.07F},
              0.8F);
  bar(metal, pedals + Vector3f(0, 0, 0.05F), Vector3f(-0.16F, 0.0F, 0.22F), 0.008F);  // kickstand
  add_ring(room, at, metal, pedals + Vector3f(0, 0, 0.05F), 0.08F, 0.006F);
}

}  // namespace roomcast::simulator
