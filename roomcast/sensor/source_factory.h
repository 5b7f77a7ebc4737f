// SPDX-License-Identifier: Apache-2.0
// From a SPEC on the command line to a FrameSource:  sim[:scene][#sensor]  rig:DIR#s0  tum:DIR
// freenect:0  openni2:[URI or FILE.oni]  realsense:[SERIAL]  freenect2:[SERIAL]  k4a:[SERIAL]
// mcap:FILE#s0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/source/camera/camera_settings.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::sensor {

struct SourceOptions {
  source::Pace pace = source::Pace::kRealTime;
  bool loop = true;                        // recordings start again at their end
  double sim_fps = 15;                     // sim: frames per second
  int sim_sensor_count = 3;                // sim: how many sensors stand around the room
  std::uint64_t sim_seed = 1;              // sim: noise and furniture
  source::CameraSettings camera = {};              // cameras: what is asked of them
  std::filesystem::path calibration = {};  // a camera.json to believe more than the source itself
  LogSink log = {};  // cameras: that they were lost and came back; called from a thread of theirs
};

/// kInvalidArgument for a SPEC that names no kind we have (the message lists them); kUnsupported
/// for a kind of camera that this program was built without; else the kind's own errors, and those
/// of with_calibration.
[[nodiscard]] Result<std::unique_ptr<source::FrameSource>> open_source(const std::string& spec,
                                                               const SourceOptions& options = {});

}  // namespace roomcast::sensor
