// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/triangle_mesh.h"

#include <cmath>

#include "roomcast/simulator/scene/angles.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr int kTurnedSegments = 20;

std::uint32_t add_vertex(TriangleMesh& mesh, const Affine3f& world_from_local,
                         const Vector3f& position, const Vector3f& normal, const Vector2f& uv_m) {
  mesh.positions.push_back(world_from_local * position);
  mesh.normals.push_back((world_from_local.linear() * normal).normalized());
  mesh.uv_m.push_back(uv_m);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void add_triangle(TriangleMesh& mesh, SurfaceIndex surface, std::uint32_t a, std::uint32_t b,
                  std::uint32_t c) {
  mesh.triangles.push_back({a, b, c});
  mesh.surface.push_back(surface);
}

struct GridPoint {
  Vector3f position;
  Vector2f uv_m;
};

/// A smooth grid of (columns+1) x (rows+1) points: normals from the differences of neighbours.
template <class PointAt>
void add_smooth_grid(TriangleMesh& mesh, SurfaceIndex surface, const Affine3f& world_from_local,
                     int columns, int rows, const PointAt& point_at) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  constexpr float kStep = 0.02F;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const float s = static_cast<float>(i) / static_cast<float>(columns);
      const float t = static_cast<float>(j) / static_cast<float>(rows);
      const GridPoint here = point_at(s, t);
      const float inner_t = std::clamp(t, kStep, 1.0F - kStep);  // poles have no tangent
      const Vector3f along_s =
          point_at(s + kStep, inner_t).position - point_at(s - kStep, inner_t).position;
      const Vector3f along_t =
          point_at(s, inner_t + kStep).position - point_at(s, inner_t - kStep).position;
      add_vertex(mesh, world_from_local, here.position, along_s.cross(along_t), here.uv_m);
    }
  }
  const auto stride = static_cast<std::uint32_t>(columns + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j) {
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(columns); ++i) {
      const std::uint32_t corner = first + j * stride + i;
      add_triangle(mesh, surface, corner, corner + 1, corner + stride);
      add_triangle(mesh, surface, corner + 1, corner + stride + 1, corner + stride);
    }
  }
}

float signed_power(float base, float exponent) {
  return std::copysign(std::pow(std::abs(base), exponent), base);
}

}  // namespace

void add_quad(TriangleMesh& mesh, SurfaceIndex surface, const Affine3f& world_from_local,
              const Vector3f& corner, const Vector3f& edge_u, const Vector3f& edge_v) {
  const Vector3f normal = edge_u.cross(edge_v);
  const float u = edge_u.norm();
  const float v = edge_v.norm();
  const auto a = add_vertex(mesh, world_from_local, corner, normal, {0, 0});
  const auto b = add_vertex(mesh, world_from_local, corner + edge_u, normal, {u, 0});
  const auto c = add_vertex(mesh, world_from_local, corner + edge_u + edge_v, normal, {u, v});
  const auto d = add_vertex(mesh, world_from_local, corner + edge_v, normal, {0, v});
  add_triangle(mesh, surface, a, b, c);
  add_triangle(mesh, surface, a, c, d);
}

void add_box(TriangleMesh& mesh, SurfaceIndex surface, const Affine3f& world_from_local,
             const Vector3f& low, const Vector3f& high) {
  const Vector3f size = high - low;
  for (int axis = 0; axis < 3; ++axis) {
    int first = (axis + 1) % 3;
    int second = (axis + 2) % 3;
    if (size[second] > size[first]) std::swap(first, second);
    const Vector3f edge_u = Vector3f::Unit(first) * size[first];
    const Vector3f edge_v = Vector3f::Unit(second) * size[second];
    const Vector3f up = Vector3f::Unit(axis) * size[axis];
    const bool turns_up = edge_u.cross(edge_v)[axis] > 0;
    const Vector3f top_corner = turns_up ? Vector3f(low + up) : Vector3f(low + up + edge_v);
    const Vector3f bottom_corner = turns_up ? Vector3f(low + edge_v) : low;
    const Vector3f top_v = turns_up ? edge_v : Vector3f(-edge_v);
    add_quad(mesh, surface, world_from_local, top_corner, edge_u, top_v);
    add_quad(mesh, surface, world_from_local, bottom_corner, edge_u, -top_v);
  }
}

void add_turned(TriangleMesh& mesh, SurfaceIndex surface, const Affine3f& world_from_local,
                std::span<const Vector2f> radius_and_height) {
  float along = 0.0F;
  for (std::size_t i = 0; i + 1 < radius_and_height.size(); ++i) {
    const Vector2f bottom = radius_and_height[i];
    const Vector2f top = radius_and_height[i + 1];
    const Vector2f slope = top - bottom;
    const float widest = std::max(bottom.x(), top.x());
    const auto point = [&](float s, float t) -> GridPoint {
      const float angle = -2.0F * kPi * s;
      const Vector2f at = bottom + slope * t;
      return {{at.x() * std::cos(angle), at.y(), at.x() * std::sin(angle)},
              {2.0F * kPi * widest * s, along + slope.norm() * t}};
    };
    add_smooth_grid(mesh, surface, world_from_local, kTurnedSegments, 1, point);
    along += slope.norm();
  }
}

void add_tube(TriangleMesh& mesh, SurfaceIndex surface, const Affine3f& world_from_local,
              std::span<const Vector3f> line, float radius_m) {
  constexpr int kSides = 8;
  float along = 0.0F;
  Vector3f side = (line[1] - line[0]).normalized().unitOrthogonal();
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vector3f before = line[i > 0 ? i - 1 : i];
    const Vector3f after = line[std::min(i + 1, line.size() - 1)];
    const Vector3f way = (after - before).normalized();
    side = (side - side.dot(way) * way).normalized();  // rotates no more than the line does
    const Vector3f other = way.cross(side);
    if (i > 0) along += (line[i] - line[i - 1]).norm();
    for (int k = 0; k <= kSides; ++k) {
      const float angle = 2.0F * kPi * static_cast<float>(k) / static_cast<float>(kSides);
      const Vector3f out = std::cos(angle) * side + std::sin(angle) * other;
      add_vertex(mesh, world_from_local, line[i] + radius_m * out, out, {radius_m * angle, along});
    }
  }
  constexpr std::uint32_t kRing = kSides + 1;
  for (std::uint32_t i = 0; i + 1 < line.size(); ++i) {
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const std::uint32_t corner = first + i * kRing + k;
      add_triangle(mesh, surface, corner, corner + 1, corner + kRing);
      add_triangle(mesh, surface, corner + 1, corner + kRing + 1, corner + kRing);
    }
  }
}

void add_cushion(TriangleMesh& mesh, SurfaceIndex surface, const Affine3f& world_from_local,
                 const Vector3f& centre, const Vector3f& half_size, float roundness) {
  const float around = 2.0F * (half_size.x() + half_size.z());
  const auto point = [&](float s, float t) -> GridPoint {
    const float angle = -2.0F * kPi * s;
    const float rise = kPi * (t - 0.5F);
    const float ring = signed_power(std::cos(rise), roundness);
    const Vector3f unit(ring * signed_power(std::cos(angle), roundness),
                        signed_power(std::sin(rise), roundness),
                        ring * signed_power(std::sin(angle), roundness));
    return {centre + unit.cwiseProduct(half_size), {around * s, 2.0F * half_size.y() * t}};
  };
  const bool small = half_size.minCoeff() < 0.05F;
  add_smooth_grid(mesh, surface, world_from_local, small ? 16 : 36, small ? 10 : 20, point);
}

void add_leaf(TriangleMesh& mesh, SurfaceIndex surface, const Affine3f& world_from_local,
              float length_m, float width_m, float rise) {
  const auto point = [&](float s, float t) -> GridPoint {
    const float outline = std::sin(kPi * std::pow(std::clamp(t, 0.0F, 1.0F), 0.8F));
    const float across = (s - 0.5F) * width_m * outline;
    const float height = length_m * (rise * t - 0.9F * t * t) + 0.25F * std::abs(across);
    return {{across, height, length_m * t}, {across, length_m * t}};
  };
  add_smooth_grid(mesh, surface, world_from_local, 4, 10, point);
}

void add_curtain(TriangleMesh& mesh, SurfaceIndex surface, const Affine3f& world_from_local,
                 const Vector2f& size_m, float fold_depth_m, int fold_count) {
  const auto point = [&](float s, float t) -> GridPoint {
    const float phase = 2.0F * kPi * static_cast<float>(fold_count) * s;
    const float loose = 0.6F + 0.4F * (1.0F - t) + 0.3F * std::sin(3.1F * phase / 7.0F);
    return {{size_m.x() * s, size_m.y() * t, fold_depth_m * loose * std::sin(phase)},
            {1.6F * size_m.x() * s, size_m.y() * t}};
  };
  add_smooth_grid(mesh, surface, world_from_local, 10 * fold_count, 6, point);
}

}  // namespace roomcast::simulator
