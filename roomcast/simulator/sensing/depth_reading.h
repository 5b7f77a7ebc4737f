// SPDX-License-Identifier: Apache-2.0
// What is in front of one depth pixel, before any error: the surface at its centre, and, where the
// pixel lies on an edge, the other surface that it sees too. Metres.
#pragma once

#include <array>

namespace roomcast::simulator {

/// How much of a camera's own light comes back from a surface, in units of a perfect white one
/// metre in front of it: infrared * cos(incidence) / z^2.
[[nodiscard]] float signal_strength(float infrared, float facing, float z_m);

/// Whether two neighbouring depths are different surfaces.
[[nodiscard]] bool is_depth_step(float a_m, float b_m);

/// One of four places inside a pixel.
struct FineSample {
  float z_m = 0;  // 0: nothing
  float strength = 0;
};

/// A second surface in the same pixel, across a step in depth.
struct OtherSurface {
  float share = 0;  // of the pixel's area; 0: there is none
  float z_m = 0;
  float strength = 0;  // relative to that of the surface at the centre
};

struct DepthReading {
  float z_m = 0;     // 0: nothing there
  float facing = 1;  // cosine of the angle of incidence
  float infrared = 0.5F;
  float detour_m = 0;  // how much too long the mean path of the light is (multipath)
  OtherSurface other;
};

/// The second surface, from what the four samples of a pixel see beside the one at its centre.
[[nodiscard]] OtherSurface other_surface(const DepthReading& centre,
                                         const std::array<FineSample, 4>& samples);

}  // namespace roomcast::simulator
