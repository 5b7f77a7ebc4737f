// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/model_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace roomcast::render {
namespace {

/// A few triangles wide: the hub's model has some of 2 cm. Cells of 10 cm cost the same, of 25 cm
/// more.
constexpr float kCell_m = 0.16F;

using CellPlace = std::array<int, 3>;

CellPlace cell_of(const Eigen::Vector3f& at_m) {
  const auto along = [&](int axis) { return static_cast<int>(std::floor(at_m[axis] / kCell_m)); };
  return {along(0), along(1), along(2)};
}

/// One eye's part of the picture.
struct EyePart {
  Eigen::Matrix4f clip_from_world;
  Eigen::Vector2i first_px, size_px;
  const HoleMap* holes;

  [[nodiscard]] Eigen::Vector4f clip(const Eigen::Vector3f& at_m) const {
    return clip_from_world.leftCols<3>() * at_m + clip_from_world.col(3);
  }
};

/// Whether there is a hole in the rectangle between two corners, given from -1 to 1 in the eye's
/// part. The rectangle is widened by half a pixel on each side, because drivers round.
bool is_near_hole(const EyePart& eye, const Eigen::Vector2f& low, const Eigen::Vector2f& high) {
  if ((low.array() > 1).any() || (high.array() < -1).any()) return false;
  const Eigen::Array2f half_px = 0.5F * eye.size_px.cast<float>();
  const auto pixel = [&](const Eigen::Array2f& at_px) -> Eigen::Vector2i {
    const Eigen::Array2f last_px = eye.size_px.cast<float>().array() - 1;
    return eye.first_px + at_px.max(0).min(last_px).matrix().cast<int>();
  };
  return eye.holes->has_hole(pixel(half_px * (low.array() + 1) - 0.5F),
                             pixel(half_px * (high.array() + 1) + 0.5F));
}

bool may_fill(const EyePart& eye, const Eigen::AlignedBox3f& box_m) {
  Eigen::Vector2f low = Eigen::Vector2f::Constant(std::numeric_limits<float>::max());
  Eigen::Vector2f high = -low;
  int behind = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector4f clip =
        eye.clip(box_m.corner(static_cast<Eigen::AlignedBox3f::CornerType>(corner)));
    if (clip.w() <= 0) {
      ++behind;
      continue;
    }
    const Eigen::Vector2f at = clip.head<2>() / clip.w();
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  return behind == 0 ? is_near_hole(eye, low, high) : behind < 8;
}

float cross(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool may_fill(const EyePart& eye, const std::array<Eigen::Vector3f, 3>& corners_m) {
  std::array<Eigen::Vector2f, 3> at;
  int behind = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector4f clip = eye.clip(corners_m[i]);
    behind += clip.w() <= 0 ? 1 : 0;
    at[i] = clip.head<2>() / clip.w();
  }
  if (behind > 0) return behind < 3;
  if (cross(at[1] - at[0], at[2] - at[0]) <= 0) return false;  // its back
  return is_near_hole(eye, at[0].cwiseMin(at[1]).cwiseMin(at[2]),
                      at[0].cwiseMax(at[1]).cwiseMax(at[2]));
}

}  // namespace

ModelCells::ModelCells(std::span<const Eigen::Vector3f> points_m,
                       std::span<const ModelTriangle> triangles)
    : points_m_(points_m.begin(), points_m.end()) {
  std::vector<std::pair<CellPlace, ModelTriangle>> sorted;
  sorted.reserve(triangles.size());
  for (const ModelTriangle& triangle : triangles)
    sorted.emplace_back(cell_of(points_m[triangle[0]]), triangle);
  std::ranges::sort(sorted);
  triangles_.reserve(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i == 0 || sorted[i].first != sorted[i - 1].first) cells_.emplace_back();
    triangles_.push_back(sorted[i].second);
    for (const std::uint32_t point : sorted[i].second) cells_.back().box_m.extend(points_m[point]);
    cells_.back().end = i + 1;
  }
}

void ModelCells::add_near_holes(const Eyes& eyes, const HoleMap& holes,
                                std::vector<ModelTriangle>& near_holes) const {
  const EyeMatrices clip = clip_from_world(eyes);
  std::vector<EyePart> parts;
  for (int eye = 0; eye < eyes.count(); ++eye)
    parts.push_back({clip[static_cast<std::size_t>(eye)],
                     {eye * eyes.width(), 0},
                     {eyes.width(), eyes.height()},
                     &holes});
  const auto in_some_part = [&](const auto& shape) {
    return std::ranges::any_of(parts, [&](const EyePart& eye) { return may_fill(eye, shape); });
  };
  std::size_t begin = 0;
  for (const Cell& cell : cells_) {
    const auto of_cell = std::span(triangles_).subspan(begin, cell.end - begin);
    begin = cell.end;
    if (!in_some_part(cell.box_m)) continue;
    for (const ModelTriangle& triangle : of_cell) {
      const std::array<Eigen::Vector3f, 3> corners_m = {
          points_m_[triangle[0]], points_m_[triangle[1]], points_m_[triangle[2]]};
      if (in_some_part(corners_m)) near_holes.push_back(triangle);
    }
  }
}

}  // namespace roomcast::render
