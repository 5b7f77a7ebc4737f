// SPDX-License-Identifier: Apache-2.0
// The patterns of surface.h, one function each: surface, point in metres, pixel footprint in metres
// -> albedo.
#pragma once

#include <algorithm>

#include <Eigen/Core>

#include "roomcast/simulator/scene/surface.h"

namespace roomcast::simulator {

/// Interpolates between two colours; the share is clamped to 0..1.
inline Eigen::Vector3f mix(const Eigen::Vector3f& a, const Eigen::Vector3f& b, float share_of_b) {
  return a + (b - a) * std::clamp(share_of_b, 0.0F, 1.0F);
}

// Building materials.
Eigen::Vector3f plain(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f plaster(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f planks(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f wood(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f brick(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f wallpaper(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f carpet_tiles(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f tiles(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f flat_paint(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f concrete(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f terrazzo(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);

// Cloth.
Eigen::Vector3f rug(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f fabric(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f plaid(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f denim(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f stripes(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);

// Pictures and printed objects.
Eigen::Vector3f book_spine(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f painting(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f garden(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f leaf(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f screen(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f drawings(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f face(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f poster(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);

// Equipment.
Eigen::Vector3f rack_face(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f tag(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);
Eigen::Vector3f keys(const Surface& s, const Eigen::Vector2f& at_m, float footprint_m);

}  // namespace roomcast::simulator
