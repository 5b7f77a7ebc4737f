// SPDX-License-Identifier: Apache-2.0
// TriangleMesh, and the basic shapes of furniture. Metres; `u`, `v` are metres along the surface,
// so that patterns have their true size. Shapes are added in a local frame (y up) through
// `world_from_local`.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace roomcast::simulator {

/// Index into Room::surfaces.
using SurfaceIndex = std::uint16_t;

struct TriangleMesh {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;  // one per position, unit length
  std::vector<Eigen::Vector2f> uv_m;     // one per position
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<SurfaceIndex> surface;  // one per triangle
};

/// A parallelogram; u runs along `edge_u` and v along `edge_v` from `corner`.
void add_quad(TriangleMesh& mesh, SurfaceIndex surface, const Eigen::Affine3f& world_from_local,
              const Eigen::Vector3f& corner, const Eigen::Vector3f& edge_u,
              const Eigen::Vector3f& edge_v);

/// A box with faces along the local axes. On every face u runs along the longer side (wood grain).
void add_box(TriangleMesh& mesh, SurfaceIndex surface, const Eigen::Affine3f& world_from_local,
             const Eigen::Vector3f& low, const Eigen::Vector3f& high);

/// A surface of revolution about local y through (radius, height) points, from bottom to top; sharp
/// at these points, smooth about the axis. Ends with radius 0 are closed.
void add_turned(TriangleMesh& mesh, SurfaceIndex surface, const Eigen::Affine3f& world_from_local,
                std::span<const Eigen::Vector2f> radius_and_height);

/// A round tube along a polyline, its ends open; u runs around it, v along it.
void add_tube(TriangleMesh& mesh, SurfaceIndex surface, const Eigen::Affine3f& world_from_local,
              std::span<const Eigen::Vector3f> line, float radius_m);

/// A soft box or ball: a superellipsoid of the given half sizes. `roundness` 1: ellipsoid, towards
/// 0: box.
void add_cushion(TriangleMesh& mesh, SurfaceIndex surface, const Eigen::Affine3f& world_from_local,
                 const Eigen::Vector3f& centre, const Eigen::Vector3f& half_size, float roundness);

/// A leaf that starts at the local origin along +z, rises and droops; u across from the midrib, v
/// along it.
void add_leaf(TriangleMesh& mesh, SurfaceIndex surface, const Eigen::Affine3f& world_from_local,
              float length_m, float width_m, float rise);

/// A hanging cloth in the local xy plane with vertical folds in z.
void add_curtain(TriangleMesh& mesh, SurfaceIndex surface, const Eigen::Affine3f& world_from_local,
                 const Eigen::Vector2f& size_m, float fold_depth_m, int fold_count);

}  // namespace roomcast::simulator
