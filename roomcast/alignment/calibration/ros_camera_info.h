// SPDX-License-Identifier: Apache-2.0
// ROS's calibration files (camera_info as YAML, written by camera_calibration and read by
// camera_info_manager): image_width, image_height, camera_matrix.data, distortion_model plumb_bob,
// distortion_coefficients.data (k1 k2 p1 p2 k3). Thread-safe (no state).
#pragma once

#include <filesystem>
#include <string>

#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::alignment::calibration {

inline constexpr std::size_t kMaxCameraInfoBytes = 64U << 10U;

/// kMalformed names the invalid field; kUnsupported: a lens model other than plumb_bob.
[[nodiscard]] Result<CameraIntrinsics> parse_camera_info(const std::string& yaml);

/// kNotFound, kTooLarge, and the errors above with the file's name.
[[nodiscard]] Result<CameraIntrinsics> read_camera_info(const std::filesystem::path& file);

}  // namespace roomcast::alignment::calibration
