// SPDX-License-Identifier: Apache-2.0
// MovingLayer: the moving things as seen by one camera: for each pixel the front-most triangle, the
// position on it and its depth. Every pixel's ray is intersected with the triangles, so depths
// equal those of a ray caster, including lens distortion; only pixels that a triangle may cover are
// tested. Reused from frame to frame; allocates only for a new set of things. Depth z in metres
// along the optical axis. Single-threaded. Ray-triangle test by signed volumes: Segura & Feito
// 2001.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/simulator/people/moving_things.h"
#include "roomcast/simulator/people/picture_tiles.h"
#include "roomcast/simulator/tracing/placed_camera.h"

namespace roomcast::simulator {

class MovingLayer {
 public:
  static constexpr std::uint32_t kNoTriangle = ~0U;

  MovingLayer(int width, int height);

  /// With `wanted`, only these tiles are guaranteed to be drawn.
  void draw(const MovingThings& things, const PlacedCamera& camera,
            const PictureTiles* wanted = nullptr);

  /// Contains every pixel that shows a moving thing.
  [[nodiscard]] const PixelBox& box() const { return box_; }
  [[nodiscard]] ImageView<const float> z_m() const { return z_m_.view(); }  // infinity: nothing
  [[nodiscard]] ImageView<const std::uint32_t> triangle() const { return triangle_.view(); }
  /// Barycentric weights of the triangle's second and third corner; the first has the remainder.
  [[nodiscard]] ImageView<const Eigen::Vector2f> corner_shares() const { return shares_.view(); }

 private:
  void clear();
  void draw_part(const MovingThings& things, const MovingPart& part, const PlacedCamera& camera);
  void draw_triangle(const TriangleMesh& mesh, std::uint32_t number, const PixelBox& limits,
                     const PlacedCamera& camera);

  Image<float> z_m_;
  Image<std::uint32_t> triangle_;
  Image<Eigen::Vector2f> shares_;
  PixelBox box_;
  const PictureTiles* wanted_ = nullptr;  // only during draw()
  struct Seen {
    Eigen::Vector3f in_camera_m;
    Eigen::Vector2f pixel;
    bool is_projected;  // has_pixel and pixel are valid; computed for front faces only
    bool has_pixel;     // in front of the camera, and inside the lens model's domain
  };
  void project_vertex(std::uint32_t vertex, const PlacedCamera& camera);
  std::vector<Seen> vertices_;
};

/// The surface point seen at pixel (x, y) of the layer.
struct MovingPoint {
  Eigen::Vector3f position_m;
  Eigen::Vector3f normal;  // unit length
  Eigen::Vector2f uv_m;
  SurfaceIndex surface;
  float facing;  // cosine between the normal and the direction to the camera
};
/// Requires that the layer has a surface at the pixel.
[[nodiscard]] MovingPoint moving_point(const MovingThings& things, const MovingLayer& layer,
                                       const PlacedCamera& camera, int x, int y);
/// Only MovingPoint::facing.
[[nodiscard]] inline float facing_at(const MovingThings& things, const MovingLayer& layer,
                                     const PlacedCamera& camera, int x, int y) {
  const auto& corner = things.mesh().triangles[layer.triangle().at(x, y)];
  const auto& normals = things.mesh().normals;
  const Eigen::Vector2f share = layer.corner_shares().at(x, y);
  const float first = 1.0F - share.x() - share.y();
  const Eigen::Vector3f normal =
      first * normals[corner[0]] + share.x() * normals[corner[1]] + share.y() * normals[corner[2]];
  const Eigen::Vector3f direction = camera.direction(x, y);
  const float lengths = std::sqrt(normal.squaredNorm() * direction.squaredNorm());
  return std::clamp(-normal.dot(direction) / lengths, 0.0F, 1.0F);
}

}  // namespace roomcast::simulator
