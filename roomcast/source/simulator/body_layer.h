// SPDX-License-Identifier: Apache-2.0
// The walking person as one camera sees them: for each pixel which part is in front and how far away. Only the
// pixels of the limbs' bounding boxes are looked at. Reused from frame to frame; allocates at construction only.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/source/simulator/static_plate.h"
#include "roomcast/source/simulator/walking_body.h"

namespace roomcast::sim {

/// Columns left <= x < right, rows top <= y < bottom. Empty when right <= left.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
  [[nodiscard]] bool empty() const { return right <= left || bottom <= top; }
};

/// Smallest box of pixels that holds all of an axis-aligned box of a local frame; the whole picture when part of it
/// is behind the camera.
[[nodiscard]] PixelBox pixels_of_box(const PlacedCamera& camera, const Eigen::Affine3f& world_from_local,
                                     const Eigen::Vector3f& low, const Eigen::Vector3f& high);

class BodyLayer {
 public:
  static constexpr std::uint8_t kNoPart = 255;

  explicit BodyLayer(const CameraIntrinsics& camera);

  void draw(const WalkingBody& body, const PlacedCamera& camera);

  [[nodiscard]] const PixelBox& box() const { return box_; }
  [[nodiscard]] ImageView<const float> z_m() const { return z_m_.view(); }  // infinity where nobody is
  [[nodiscard]] ImageView<const std::uint8_t> part() const { return part_.view(); }

 private:
  void clear();
  void draw_part(const BodyPart& part, std::uint8_t number, const PlacedCamera& camera);

  Image<float> z_m_;
  Image<std::uint8_t> part_;
  PixelBox box_;
};

/// The surface point of the body that pixel (x, y) sees at depth z.
struct BodyPoint {
  Eigen::Vector3f position_m;
  Eigen::Vector3f normal;  // unit length
  Eigen::Vector2f cloth_m;
  float facing;  // cosine between the normal and the way back to the camera
};
[[nodiscard]] BodyPoint body_point(const BodyPart& part, const PlacedCamera& camera, int x, int y, float z_m);

}  // namespace roomcast::sim
