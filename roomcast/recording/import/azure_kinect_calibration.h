// SPDX-License-Identifier: Apache-2.0
// The factory calibration of an Azure Kinect (calibration.json, an attachment of its recordings):
// cameras "D0" and "PV0", each with a rational lens of the whole sensor in units of its width and
// height, and a pose. A mode of the camera crops and bins that sensor; pixel centres are at integer
// coordinates afterwards. Modes after the Azure Kinect Sensor SDK. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::recording {

struct AzureKinectCalibration {
  SensorCalibration cameras;
  double depth_error_px = 0, color_error_px = 0;  // of converting the lenses (rational_lens.h)
};

/// `depth_mode`: "NFOV_UNBINNED", "NFOV_2X2BINNED", "WFOV_UNBINNED" or "WFOV_2X2BINNED";
/// `color_height`: 720, 1080, 1440, 1536, 2160, 3072; 0: without colour, `color` equals `depth`
/// then. kMalformed: not such a calibration; kUnsupported: another mode.
[[nodiscard]] Result<AzureKinectCalibration> read_azure_kinect_calibration(
    std::span<const std::uint8_t> json, const std::string& depth_mode, int color_height);

}  // namespace roomcast::recording
