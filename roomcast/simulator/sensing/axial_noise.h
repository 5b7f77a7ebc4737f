// SPDX-License-Identifier: Apache-2.0
// Published formulas for the random error of depth along the optical axis: one standard deviation
// in millimetres from range z in metres and angle of incidence theta in radians. Pure functions.
#pragma once

namespace roomcast::simulator {

/// Kinect v2: 1.5 - 0.5 z + 0.3 z^2 + 0.1 z^1.5 theta^2 / (pi/2 - theta)^2. Fankhauser, Bloesch,
/// Rodriguez, Kaestner, Hutter, Siegwart, "Kinect v2 for mobile robot navigation: evaluation and
/// modeling", ICAR 2015. Measured up to about 3 m; used unchanged beyond. The last term has a pole:
/// angles above 72 degrees are treated as 72.
[[nodiscard]] float kinect2_sigma_mm(float z_m, float theta);

/// Azure Kinect, narrow field of view, unbinned. Kurillo, Hemingway, Cheng, Cheng, "Evaluating the
/// accuracy of the Azure Kinect and Kinect v2", Sensors 22(7), 2022: comparable to the Kinect v2 up
/// to 2.5 m, better beyond. Therefore: the Kinect v2's formula up to 2.5 m, then linear with the
/// slope at that range (the second part is ours). Stays below the 17 mm of the manufacturer's
/// specification.
[[nodiscard]] float azure_sigma_mm(float z_m, float theta);

/// A stereo pair: z^2 * subpixel / (f * baseline), all in millimetres and pixels. Grunnet-Jepsen,
/// Sweetser, Woodfill, "Tuning depth cameras for best performance", Intel.
[[nodiscard]] float stereo_sigma_mm(float z_m, float focal_px, float baseline_mm, float subpixel);

}  // namespace roomcast::simulator
