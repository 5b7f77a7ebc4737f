// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/scene/patterns.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

std::uint32_t cell_hash(float column, float row, std::uint32_t seed) {
  return hash_of(hash_of(seed, static_cast<std::uint32_t>(static_cast<int>(column))),
                 static_cast<std::uint32_t>(static_cast<int>(row)));
}

/// Fibres along u: noise with long wavelength in u and short in v.
float grain(const Vector2f& at_m, float footprint_m, std::uint32_t seed) {
  const Vector2f stretched(at_m.x() * 0.12F, at_m.y());
  return fractal_noise(stretched, 0.03F, 3, footprint_m, seed);
}

/// 1 inside a joint of the given width at the borders of a cell of `extent_m`, blurred by the
/// footprint.
float joint(float in_cell_m, float extent_m, float width_m, float footprint_m) {
  const float to_border = std::min(in_cell_m, extent_m - in_cell_m);
  const float blur = std::max(footprint_m, 0.001F);
  return std::clamp((width_m * 0.5F - to_border) / blur + 0.5F, 0.0F, 1.0F) *
         std::min(1.0F, width_m / blur + 0.25F);
}

struct Cell {
  float column, row;  // indices of the cell
  Vector2f inside_m;  // position in the cell
  std::uint32_t hash;
};

/// Courses of `size_m` cells, each shifted by its own offset (bricks: half a cell, boards: random).
Cell course_cell(const Vector2f& at_m, const Vector2f& size_m, bool half_bond, std::uint32_t seed) {
  const float row = std::floor(at_m.y() / size_m.y());
  const float random_shift = unit_from_hash(cell_hash(0.0F, row, seed ^ 77U));
  const float shift = half_bond ? 0.5F * (row - 2.0F * std::floor(row * 0.5F)) : random_shift;
  const float u = at_m.x() / size_m.x() + shift;
  const float column = std::floor(u);
  return {column,
          row,
          {(u - column) * size_m.x(), at_m.y() - row * size_m.y()},
          cell_hash(column, row, seed)};
}

}  // namespace

Vector3f plain(const Surface& s, const Vector2f& at_m, float footprint_m) {
  return s.base * (1.0F + 0.10F * fractal_noise(at_m, 0.08F, 4, footprint_m, s.seed));
}

Vector3f plaster(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const float clouds = fractal_noise(at_m, 0.9F, 3, footprint_m, s.seed);
  const float roller = fractal_noise(at_m, 0.05F, 4, footprint_m, s.seed + 9U);
  return s.base * (1.0F + 0.06F * clouds + 0.09F * roller);
}

Vector3f planks(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f board_m(1.35F, 0.135F);
  const Cell board = course_cell(at_m, board_m, false, s.seed);
  const float tone = unit_from_hash(board.hash);
  const Vector2f own_grain = board.inside_m + Vector2f(tone * 40.0F, tone * 17.0F);
  const float fibres = grain(own_grain, footprint_m, board.hash);
  const float rings =
      fractal_noise({own_grain.x() * 0.4F, own_grain.y()}, 0.16F, 3, footprint_m, board.hash + 3U);
  const Vector3f color =
      mix(s.base, s.accent, tone * 0.8F + 0.35F * rings) * (1.0F + 0.30F * fibres);
  const float gap = std::max(joint(board.inside_m.x(), board_m.x(), 0.003F, footprint_m),
                             joint(board.inside_m.y(), board_m.y(), 0.003F, footprint_m));
  return mix(color, s.trim, gap);
}

Vector3f wood(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const float bend = 0.03F * fractal_noise(at_m, 0.5F, 2, footprint_m, s.seed + 5U);
  const Vector2f bent(at_m.x(), at_m.y() + bend);
  const float rings = fractal_noise({bent.x() * 0.15F, bent.y()}, 0.07F, 4, footprint_m, s.seed);
  const float fibres = grain(bent, footprint_m, s.seed + 11U);
  return mix(s.base, s.accent, 0.5F + 0.7F * rings) * (1.0F + 0.18F * fibres);
}

Vector3f brick(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f brick_m(0.25F, 0.077F);
  const float wobble = 0.003F * fractal_noise(at_m, 0.06F, 2, footprint_m, s.seed + 1U);
  const Cell cell = course_cell(at_m + Vector2f(wobble, wobble), brick_m, true, s.seed);
  const float rough = fractal_noise(at_m, 0.03F, 4, footprint_m, cell.hash);
  const Vector3f color = mix(s.base, s.accent, unit_from_hash(cell.hash)) * (1.0F + 0.28F * rough);
  const float mortar = std::max(joint(cell.inside_m.x(), brick_m.x(), 0.012F, footprint_m),
                                joint(cell.inside_m.y(), brick_m.y(), 0.012F, footprint_m));
  return mix(color, s.trim * (1.0F + 0.2F * rough), mortar);
}

Vector3f wallpaper(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f motif_m(0.26F, 0.34F);
  const Cell cell = course_cell({at_m.y(), at_m.x()}, {motif_m.y(), motif_m.x()}, true, s.seed);
  const Vector2f p((cell.inside_m.x() - 0.5F * motif_m.y()) / motif_m.x(),
                   cell.inside_m.y() / motif_m.x() - 0.5F);
  const float angle = std::atan2(p.y(), p.x());
  const float petals = 5.0F + std::floor(3.0F * unit_from_hash(cell.hash));
  const float turn = 6.28F * nth_unit(cell.hash, 5U);
  const float edge = 0.24F + 0.09F * std::cos(petals * angle + turn);
  const float blur = std::max(0.02F, footprint_m / motif_m.x());
  const float flower = std::clamp((edge - p.norm()) / blur, 0.0F, 1.0F);
  const float heart = std::clamp((0.07F - p.norm()) / blur, 0.0F, 1.0F);
  const float aged = 1.0F + 0.07F * fractal_noise(at_m, 0.7F, 5, footprint_m, s.seed + 2U);
  const float strength = 0.35F + 0.55F * nth_unit(cell.hash, 9U);
  return mix(mix(s.base, s.accent, strength * flower), s.trim, strength * heart) * aged;
}

Vector3f carpet_tiles(const Surface& s, const Vector2f& at_m, float footprint_m) {
  const Vector2f tile_m(0.5F, 0.5F);
  const Cell cell = course_cell(at_m, tile_m, false, s.seed);
  const bool turned = (cell.hash & 64U) != 0U;
  const Vector2f pile = turned ? Vector2f(at_m.y(), at_m.x()) : at_m;
  const float strands = grain(pile * 1.5F, footprint_m, cell.hash);
  const float flecks = fractal_noise(at_m, 0.02F, 3, footprint_m, s.seed + 3U);
  const float stains = fractal_noise(at_m, 0.6F, 2, footprint_m, s.seed + 8U);
  const Vector3f color = mix(s.base, s.accent, 0.9F * unit_from_hash(cell.hash));
  return color * (1.0F + 0.30F * strands + 0.30F * flecks + 0.10F * stains);
}

}  // namespace roomcast::simulator
