// SPDX-License-Identifier: Apache-2.0
// Noise law: how a harsh unit's depth differs from its model's published figures. The laws are
// those of depth_sensing.h and depth_bias.h; the amounts are drawn for each unit.
// - Time of flight: wiggling of 4 to 15 mm (Lindner and Kolb 2006; uncorrected PMD sensors reach
//   centimetres: Foix, Alenya, Torras, "Lock-in time-of-flight cameras: a survey", IEEE Sensors
//   Journal 11(9), 2011), and noise inversely proportional to the amplitude (ibid., equation for
//   large ambient light), so that dark, slanted and far surfaces are several times as noisy.
// - Structured light: disparity noise of 0.04 to 0.09 px (Khoshelham and Oude Elberink 2012: 0.06)
//   and smooth disparity errors of up to 0.05 to 0.25 px (Herrera et al. 2012: up to 0.3), both of
//   which grow with the square of the range.
// The ranges of both begin at the figures of the literature; the upper ends are ours.
#pragma once

#include "roomcast/simulator/random/random.h"
#include "roomcast/simulator/sensing/sensor_profile.h"

namespace roomcast::simulator {

/// A unit of this model as bad as drawn, with a range of its own.
[[nodiscard]] SensorProfile with_drawn_noise(SensorProfile profile, Random& random);

}  // namespace roomcast::simulator
