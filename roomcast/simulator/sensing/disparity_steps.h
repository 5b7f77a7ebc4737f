// SPDX-License-Identifier: Apache-2.0
// Disparity steps: a structured-light sensor knows a disparity only as a multiple of a fraction of
// a pixel, so its depth has steps that grow with the square of the range: 2.8 mm * z^2 for the
// Kinect v1, 70 mm at 5 m (Khoshelham and Oude Elberink, Sensors 12(2), 2012). Pure functions.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"

namespace roomcast::simulator {

/// A pair of rays: the camera's focal length and its distance from the projector.
struct DisparitySteps {
  float focal_px = 0, baseline_mm = 0, step_px = 0;

  /// The nearest depth that the sensor can report; 0 stays 0.
  [[nodiscard]] std::uint16_t rounded_mm(std::uint16_t depth_mm) const;
};

void round_to_disparity_steps(const DisparitySteps& steps, ImageView<std::uint16_t> depth_mm);

}  // namespace roomcast::simulator
