// SPDX-License-Identifier: Apache-2.0
// Puts the walking person into the pictures of the empty room: their depth, their colours, the
// shade at their feet.
#pragma once

#include "roomcast/core/image.h"
#include "roomcast/source/simulator/people/body_layer.h"
#include "roomcast/source/simulator/people/cloth_atlas.h"
#include "roomcast/source/simulator/scene/room.h"
#include "roomcast/source/simulator/sensing/sensor_noise.h"

namespace roomcast::sim {

/// Depth in millimetres, rounded, where the person is nearer than the plate.
void put_body_depth(const BodyLayer& layer, const DepthPlate& plate,
                    ImageView<std::uint16_t> depth_mm);

/// The same as a sensor with noise reads it; also disturbs the background beside the person's
/// outline.
void put_noisy_body_depth(const WalkingBody& body, const BodyLayer& layer,
                          const PlacedCamera& camera, const DepthPlate& plate,
                          const Clothes& clothes, const DepthNoise& noise, std::uint32_t key,
                          ImageView<std::uint16_t> depth_mm);

/// Darkens the floor around the feet.
void put_floor_shade(const WalkingBody& body, const PlacedCamera& camera, const ColorPlate& plate,
                     ImageView<Rgb8> color);

/// Lit cloth and skin where the person is nearer than the plate; half-covered pixels of the outline
/// are blended.
void put_body_color(const WalkingBody& body, const BodyLayer& layer, const PlacedCamera& camera,
                    const ColorPlate& plate, const Room& room, const ClothAtlas& clothes,
                    ImageView<Rgb8> color);

}  // namespace roomcast::sim
