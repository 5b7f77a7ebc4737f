// SPDX-License-Identifier: Apache-2.0
// The walking person as one camera sees them: for each pixel which part is in front and how far
// away. Only the pixels of the limbs' bounding boxes are looked at. Reused from frame to frame;
// allocates at construction only.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/source/simulator/people/walking_body.h"
#include "roomcast/source/simulator/tracing/placed_camera.h"

namespace roomcast::sim {

class BodyLayer {
 public:
  static constexpr std::uint8_t kNoPart = 255;

  BodyLayer(int width, int height);

  void draw(const WalkingBody& body, const PlacedCamera& camera);

  [[nodiscard]] const PixelBox& box() const { return box_; }
  [[nodiscard]] ImageView<const float> z_m() const {
    return z_m_.view();
  }  // infinity where nobody is
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
[[nodiscard]] BodyPoint body_point(const BodyPart& part, const PlacedCamera& camera, int x, int y,
                                   float z_m);

}  // namespace roomcast::sim
