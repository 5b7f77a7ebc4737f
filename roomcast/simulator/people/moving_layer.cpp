// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/moving_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "roomcast/core/assert.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kNowhere_m = std::numeric_limits<float>::infinity();
constexpr float kNearest_m = 0.05F;

/// Number of neighbouring pixels of a row that are processed together.
constexpr int kLanes = 4;
using Lanes = Eigen::Array<float, kLanes, 1>;

Lanes lanes_at(const float* row) {
  return Eigen::Map<const Lanes>(row);
}

PixelBox joined(const PixelBox& a, const PixelBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

PixelBox common(const PixelBox& a, const PixelBox& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
          std::min(a.bottom, b.bottom)};
}

/// True if all points (in the optical frame) are outside the same side of the view frustum of a
/// camera with these rays, or too near: then nothing between them is visible.
template <std::size_t kCount>
bool beyond_a_side(const std::array<Vector3f, kCount>& points, const Eigen::AlignedBox2f& rays) {
  const auto all = [&points](const auto& is_beyond) {
    return std::all_of(points.begin(), points.end(), is_beyond);
  };
  return all([](const Vector3f& p) { return p.z() < kNearest_m; }) ||
         all([&](const Vector3f& p) { return p.x() < rays.min().x() * p.z(); }) ||
         all([&](const Vector3f& p) { return p.x() > rays.max().x() * p.z(); }) ||
         all([&](const Vector3f& p) { return p.y() < rays.min().y() * p.z(); }) ||
         all([&](const Vector3f& p) { return p.y() > rays.max().y() * p.z(); });
}

bool is_out_of_sight(const Eigen::AlignedBox3f& box_m, const PlacedCamera& camera) {
  std::array<Vector3f, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const Vector3f corner = box_m.corner(static_cast<Eigen::AlignedBox3f::CornerType>(i));
    corners[static_cast<std::size_t>(i)] = camera.axes().transpose() * (corner - camera.eye_m());
  }
  return beyond_a_side(corners, camera.ray_bounds());
}

}  // namespace

MovingLayer::MovingLayer(int width, int height)
    : z_m_(width, height, kNowhere_m),
      triangle_(width, height, kNoTriangle),
      shares_(width, height, Vector2f::Zero()) {
  ROOMCAST_ASSERT(width >= kLanes);
}

void MovingLayer::clear() {
  for (int y = box_.top; y < box_.bottom; ++y) {
    std::fill(z_m_.view().row(y) + box_.left, z_m_.view().row(y) + box_.right, kNowhere_m);
    std::fill(triangle_.view().row(y) + box_.left, triangle_.view().row(y) + box_.right,
              kNoTriangle);
  }
  box_ = {};
}

void MovingLayer::draw(const MovingThings& things, const PlacedCamera& camera,
                       const PictureTiles* wanted) {
  clear();
  wanted_ = wanted;
  vertices_.resize(things.mesh().positions.size());
  for (const MovingPart& part : things.parts()) draw_part(things, part, camera);
}

void MovingLayer::draw_part(const MovingThings& things, const MovingPart& part,
                            const PlacedCamera& camera) {
  if (is_out_of_sight(part.box_m, camera)) return;
  const PixelBox limits =
      camera.pixels_of_box(Eigen::Affine3f::Identity(), part.box_m.min(), part.box_m.max());
  if (limits.empty()) return;
  box_ = joined(box_, limits);
  const TriangleMesh& mesh = things.mesh();
  for (std::uint32_t i = part.first_vertex; i < part.first_vertex + part.vertex_count; ++i) {
    Seen& seen = vertices_[i];
    seen.in_camera_m = camera.axes().transpose() * (mesh.positions[i] - camera.eye_m());
    seen.is_projected = false;
  }
  for (std::uint32_t i = 0; i < part.triangle_count; ++i)
    draw_triangle(mesh, part.first_triangle + i, limits, camera);
}

void MovingLayer::project_vertex(std::uint32_t vertex, const PlacedCamera& camera) {
  Seen& seen = vertices_[vertex];
  if (seen.is_projected) return;
  const auto pixel =
      seen.in_camera_m.z() > kNearest_m ? camera.pixel_of(seen.in_camera_m) : std::nullopt;
  seen.is_projected = true;
  seen.has_pixel = pixel.has_value();
  if (pixel) seen.pixel = *pixel;
}

void MovingLayer::draw_triangle(const TriangleMesh& mesh, std::uint32_t number,
                                const PixelBox& limits, const PlacedCamera& camera) {
  const auto& corner = mesh.triangles[number];
  const Seen& a = vertices_[corner[0]];
  const Seen& b = vertices_[corner[1]];
  const Seen& c = vertices_[corner[2]];
  const Vector3f normal = (b.in_camera_m - a.in_camera_m).cross(c.in_camera_m - a.in_camera_m);
  const float plane = normal.dot(a.in_camera_m);
  if (plane >= 0.0F) return;  // back face
  for (const std::uint32_t vertex : corner) project_vertex(vertex, camera);
  PixelBox box = limits;
  if (a.has_pixel && b.has_pixel && c.has_pixel) {
    const Vector2f low = a.pixel.cwiseMin(b.pixel).cwiseMin(c.pixel);
    const Vector2f high = a.pixel.cwiseMax(b.pixel).cwiseMax(c.pixel);
    // The lens bends edges by less than a hundredth of their length, if they fit a picture.
    const float bulge = 0.05F + 0.01F * (high - low).maxCoeff();
    const auto whole = [](float value) {  // rounds down without a function call
      constexpr int kFar = 30000;
      return static_cast<int>(std::clamp(value, -1.0F * kFar, 1.0F * kFar) + kFar) - kFar;
    };
    box = common(limits, {-whole(bulge - low.x()), -whole(bulge - low.y()),
                          whole(high.x() + bulge) + 1, whole(high.y() + bulge) + 1});
  } else if (beyond_a_side(std::array{a.in_camera_m, b.in_camera_m, c.in_camera_m},
                           camera.ray_bounds())) {
    return;  // skipped: without pixel bounds the whole picture would have to be searched
  }
  if (box.empty() || (wanted_ != nullptr && !wanted_->any_in(box))) return;
  // Signed volumes of the ray with the edges; the ray is inside where all have the same sign.
  const Vector3f edge_a = c.in_camera_m.cross(b.in_camera_m);
  const Vector3f edge_b = a.in_camera_m.cross(c.in_camera_m);
  const Vector3f edge_c = b.in_camera_m.cross(a.in_camera_m);
  const int last = camera.width() - kLanes;
  for (int y = box.top; y < box.bottom; ++y) {
    const float* ray_x = camera.ray_x_row(y);
    const float* ray_y = camera.ray_y_row(y);
    float* z_row = z_m_.view().row(y);
    for (int first = box.left; first < box.right; first += kLanes) {
      const int at = std::min(first, last);
      const Lanes u = lanes_at(ray_x + at), v = lanes_at(ray_y + at);
      const Lanes wa = edge_a.x() * u + edge_a.y() * v + edge_a.z();
      const Lanes wb = edge_b.x() * u + edge_b.y() * v + edge_b.z();
      const Lanes wc = edge_c.x() * u + edge_c.y() * v + edge_c.z();
      const Lanes least = wa.min(wb).min(wc);
      if (!(least.maxCoeff() >= 0.0F)) continue;
      for (int i = first - at; i < kLanes && at + i < box.right; ++i) {
        if (!(least[i] >= 0.0F)) continue;
        const float sum = wa[i] + wb[i] + wc[i];
        const float z = plane / (normal.x() * u[i] + normal.y() * v[i] + normal.z());
        const int x = at + i;
        if (!(sum > 0.0F) || !(z > kNearest_m) || z >= z_row[x]) continue;
        z_row[x] = z;
        triangle_.at(x, y) = number;
        shares_.at(x, y) = Vector2f(wb[i], wc[i]) / sum;
      }
    }
  }
}

MovingPoint moving_point(const MovingThings& things, const MovingLayer& layer,
                         const PlacedCamera& camera, int x, int y) {
  const TriangleMesh& mesh = things.mesh();
  const std::uint32_t number = layer.triangle().at(x, y);
  const auto& corner = mesh.triangles[number];
  const Vector2f share = layer.corner_shares().at(x, y);
  const float first = 1.0F - share.x() - share.y();
  const Vector3f direction = camera.direction(x, y);
  MovingPoint point;
  point.position_m = camera.eye_m() + layer.z_m().at(x, y) * direction;
  point.normal = (first * mesh.normals[corner[0]] + share.x() * mesh.normals[corner[1]] +
                  share.y() * mesh.normals[corner[2]])
                     .normalized();
  point.uv_m = first * mesh.uv_m[corner[0]] + share.x() * mesh.uv_m[corner[1]] +
               share.y() * mesh.uv_m[corner[2]];
  point.surface = mesh.surface[number];
  point.facing = facing_at(things, layer, camera, x, y);
  return point;
}

}  // namespace roomcast::simulator
