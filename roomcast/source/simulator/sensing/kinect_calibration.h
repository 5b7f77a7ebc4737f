// SPDX-License-Identifier: Apache-2.0
// Kinect-v2-like calibrations. The depth camera is a real one: coefficients fitted to the factory
// ray table of a Kinect v2 that github.com/Vaufreyd/RGBDSyncSDK publishes. The colour camera has
// the published nominal focal length of a Kinect v2 (about 1064 px at 1920x1080), halved: 960x540
// pictures of 2x2 binned pixels, which keeps live use cheap. The cameras sit 52 mm apart, turned a
// little. As in the real device the depth picture (60 degrees) is taller than the colour picture
// (54 degrees).
#pragma once

#include "roomcast/geometry/camera_model.h"

namespace roomcast::sim {

/// Sensor 0 has the published numbers; the others differ a little in every one, as devices do.
[[nodiscard]] SensorCalibration kinect_calibration(int sensor_index);

}  // namespace roomcast::sim
