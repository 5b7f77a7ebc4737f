// SPDX-License-Identifier: Apache-2.0
// cameraconfig.json of cwipc (CWI's point cloud capture): the cameras of a recorded room, their
// files, and where they are. `trafo` maps points in metres to a world with y up, as roomcast's:
// of Kinects always from the colour camera's frame, of RealSense cameras from the depth camera's
// frame unless depth is mapped to colour (K4ABaseCamera.hpp, RS2BaseCamera.cpp of
// github.com/cwi-dis/cwipc_kinect and cwipc_realsense2). The identity means that a camera was not
// placed. Thread-safe (no state).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::recording {

inline constexpr const char* kCwipcFile = "cameraconfig.json";
inline constexpr std::size_t kMaxCwipcCameras = 64;

struct CwipcCamera {
  std::string file;  // in the folder of cameraconfig.json
  std::string serial;
  std::optional<RigidTransform> world_from_camera;  // nothing: not placed
  bool is_color_camera = true;                      // of which `world_from_camera` is; else depth's
  std::string note;                                 // a sentence, if its trafo cannot be used
};

/// Cameras that are not disabled. kNotFound; kMalformed, kUnsupported, kTooLarge: messages name the
/// file.
[[nodiscard]] Result<std::vector<CwipcCamera>> read_cwipc_config(const std::filesystem::path& file);

}  // namespace roomcast::recording
