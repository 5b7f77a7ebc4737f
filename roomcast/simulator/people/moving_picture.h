// SPDX-License-Identifier: Apache-2.0
// Composites moving things into pictures of the empty room: depth, colours and shade on the floor.
#pragma once

#include <limits>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/simulator/people/floor_shade.h"
#include "roomcast/simulator/people/moving_layer.h"
#include "roomcast/simulator/people/surface_texels.h"
#include "roomcast/simulator/scene/room.h"
#include "roomcast/simulator/tracing/static_plate.h"

namespace roomcast::simulator {

/// True if the layer has a surface nearer than the plate at a pixel.
[[nodiscard]] inline bool is_in_front(const MovingLayer& layer, const Image<float>& plate_z_m,
                                      int x, int y) {
  const float behind = plate_z_m.at(x, y);
  const float z = layer.z_m().at(x, y);  // infinity: nothing
  return z < (behind == 0.0F ? std::numeric_limits<float>::max() : behind);
}

/// Writes depth in millimetres, rounded, where a moving thing is nearer than the plate.
void put_moving_depth(const MovingLayer& layer, const DepthPlate& plate,
                      ImageView<std::uint16_t> depth_mm);

/// MovingColors: colours of moving things. Light is computed per visible vertex, so a pixel costs
/// only a look-up. Reused from frame to frame. Single-threaded.
class MovingColors {
 public:
  /// Must be called before the other calls for each instant. Keeps a reference to the room until
  /// the next call.
  void light(const MovingThings& things, const Room& room);

  /// Darkens the floor below and around moving things.
  void put_shade(const Room& room, const PlacedCamera& camera, const ColorPlate& plate,
                 ImageView<Rgb8> color) const;

  /// Draws lit cloth and skin where a moving thing is nearer than the plate; partly covered pixels
  /// of the outline are blended.
  void put(const MovingThings& things, const MovingLayer& layer, const ColorPlate& plate,
           const SurfaceTexels& texels, ImageView<Rgb8> color);

 private:
  /// Finds where the layer is nearer than the plate, in its box plus a rim of one pixel.
  void find_front(const MovingLayer& layer, const Image<float>& plate_z_m);
  /// Linear light at a vertex, computed on first use.
  const Eigen::Array4f& light_at(const MovingThings& things, std::uint32_t vertex);

  const Room* room_ = nullptr;
  std::vector<Eigen::Array4f> light_;    // per vertex
  std::vector<std::uint32_t> lit_when_;  // instant_ of the computation
  std::uint32_t instant_ = 0;
  FloorShade shade_;
  Image<std::uint8_t> front_;
};

}  // namespace roomcast::simulator
