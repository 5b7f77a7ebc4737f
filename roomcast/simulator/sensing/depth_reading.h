// SPDX-License-Identifier: Apache-2.0
// DepthReading: the true scene at one depth pixel: the surface at its centre and, if the pixel is
// on an edge, the second surface that it also sees. Metres.
#pragma once

#include <array>

namespace roomcast::simulator {

/// Returned share of a camera's own light, relative to a perfect white surface at one metre:
/// infrared * cos(incidence) / z^2.
[[nodiscard]] float signal_strength(float infrared, float facing, float z_m);

/// True if two neighbouring depths belong to different surfaces.
[[nodiscard]] bool is_depth_step(float a_m, float b_m);

/// One of four samples inside a pixel.
struct FineSample {
  float z_m = 0;  // 0: no surface
  float strength = 0;
};

/// A second surface in the same pixel, separated by a depth step.
struct OtherSurface {
  float share = 0;  // of the pixel's area; 0: no second surface
  float z_m = 0;
  float strength = 0;  // relative to that of the surface at the centre
};

struct DepthReading {
  float z_m = 0;     // 0: no surface
  float facing = 1;  // cosine of the angle of incidence
  float infrared = 0.5F;
  float detour_m = 0;  // excess of the light's mean path length (multipath)
  OtherSurface other;
};

/// Finds the second surface from the four samples of a pixel and the surface at its centre.
[[nodiscard]] OtherSurface other_surface(const DepthReading& centre,
                                         const std::array<FineSample, 4>& samples);

}  // namespace roomcast::simulator
