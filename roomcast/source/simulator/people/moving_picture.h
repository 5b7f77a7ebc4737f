// SPDX-License-Identifier: Apache-2.0
// Puts what moves into the pictures of the empty room: depth, colours, and the shade on the floor.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/source/simulator/people/moving_layer.h"
#include "roomcast/source/simulator/scene/room.h"
#include "roomcast/source/simulator/tracing/static_plate.h"

namespace roomcast::sim {

/// Whether the layer shows something nearer than the plate at a pixel.
[[nodiscard]] bool is_in_front(const MovingLayer& layer, const Image<float>& plate_z_m, int x,
                               int y);

/// Depth in millimetres, rounded, where something moving is nearer than the plate.
void put_moving_depth(const MovingLayer& layer, const DepthPlate& plate,
                      ImageView<std::uint16_t> depth_mm);

/// Darkens the floor under and around what moves.
void put_floor_shade(const MovingThings& things, const Room& room, const PlacedCamera& camera,
                     const ColorPlate& plate, ImageView<Rgb8> color);

/// Lit cloth and skin where something moving is nearer than the plate; half-covered pixels of the
/// outline are blended.
void put_moving_color(const MovingThings& things, const MovingLayer& layer,
                      const PlacedCamera& camera, const ColorPlate& plate, const Room& room,
                      ImageView<Rgb8> color);

}  // namespace roomcast::sim
