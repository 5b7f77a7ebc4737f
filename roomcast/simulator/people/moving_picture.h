// SPDX-License-Identifier: Apache-2.0
// Puts what moves into the pictures of the empty room: depth, colours, and the shade on the floor.
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

/// Whether the layer shows something nearer than the plate at a pixel.
[[nodiscard]] inline bool is_in_front(const MovingLayer& layer, const Image<float>& plate_z_m,
                                      int x, int y) {
  const float behind = plate_z_m.at(x, y);
  const float z = layer.z_m().at(x, y);  // infinity: nothing
  return z < (behind == 0.0F ? std::numeric_limits<float>::max() : behind);
}

/// Depth in millimetres, rounded, where something moving is nearer than the plate.
void put_moving_depth(const MovingLayer& layer, const DepthPlate& plate,
                      ImageView<std::uint16_t> depth_mm);

/// Colours of what moves: light is worked out per vertex that is seen, so that a pixel costs a
/// look-up. Reused from frame to frame. Single-threaded.
class MovingColors {
 public:
  /// To be called for each instant before the others. Keeps a reference to the room until then.
  void light(const MovingThings& things, const Room& room);

  /// Darkens the floor under and around what moves.
  void put_shade(const Room& room, const PlacedCamera& camera, const ColorPlate& plate,
                 ImageView<Rgb8> color) const;

  /// Lit cloth and skin where something moving is nearer than the plate; half-covered pixels of the
  /// outline are blended.
  void put(const MovingThings& things, const MovingLayer& layer, const ColorPlate& plate,
           const SurfaceTexels& texels, ImageView<Rgb8> color);

 private:
  /// Where the layer shows something nearer than the plate: its box and a rim of one pixel.
  void find_front(const MovingLayer& layer, const Image<float>& plate_z_m);
  /// Linear, of one vertex; worked out when it is first asked for.
  const Eigen::Array4f& light_at(const MovingThings& things, std::uint32_t vertex);

  const Room* room_ = nullptr;
  std::vector<Eigen::Array4f> light_;    // per vertex
  std::vector<std::uint32_t> lit_when_;  // instant_ when it was worked out
  std::uint32_t instant_ = 0;
  FloorShade shade_;
  Image<std::uint8_t> front_;
};

}  // namespace roomcast::simulator
