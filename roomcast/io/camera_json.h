// SPDX-License-Identifier: Apache-2.0
// camera.json: the cameras of one recorded sensor.
//
//   {"depth": {"width", "height", "fx", "fy", "cx", "cy", "k1", "k2", "k3", "p1", "p2"},
//    "color": {the same} or absent,
//    "color_from_depth": [16 numbers, row-major],  "color_is_registered": false,
//    "depth_scale_to_metre": 0.001,  "depth_bias_m": 0,  "invalid_depth": [0]}
//
// Lens terms are optional (0). A flat form, common for single recordings, is read too: "width",
// "height", "depth_intrinsics", "colour_registered_to_depth", and "colour_intrinsics" or
// "colour_intrinsics_estimated" with "depth_to_colour_translation_m", or "colour_tf_recorded" with
// "translation_m" and "rotation_xyzw". Pixels, metres. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::io {

struct RecordedCamera {
  SensorCalibration calibration;  // without colour: `color` equals `depth` and counts as registered
  bool has_color = true;
  double depth_scale_to_metre = 0.001;  // of the values in the depth pictures
  double depth_bias_m = 0;              // added after scaling
  std::vector<std::uint16_t> invalid_depth = {0};
};

/// Returns kNotFound if the file is missing; kMalformed, with file and field, for any other form.
[[nodiscard]] Result<RecordedCamera> read_camera_json(const std::filesystem::path& path);

/// The first form above.
[[nodiscard]] std::string camera_json_text(const RecordedCamera& camera);
/// The same for depth in millimetres with 0 as invalid.
[[nodiscard]] std::string camera_json_text(const SensorCalibration& calibration);

}  // namespace roomcast::io
