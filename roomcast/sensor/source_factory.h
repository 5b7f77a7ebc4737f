// SPDX-License-Identifier: Apache-2.0
// Opens the FrameSource that a SPEC on the command line names:
// sim[:scene][#sensor]  rig:DIR#s0  tum:DIR  mcap:FILE#s0
// recordings of other programs (recording/import/open_recording.h): mkv:FILE  bag:FILE#camera
// ros2:FILE#camera  foxglove:FILE#name  sens:FILE  r3d:FILE  cwipc:DIR#name  pictures:DIR#name
// ros2-topic:/camera/depth/image_raw[,/camera/color/image_raw]
// freenect:0  openni2:[URI or FILE.oni]  realsense:[SERIAL]  freenect2:[SERIAL]  k4a:[SERIAL]
#pragma once

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/import/room_timeline.h"
#include "roomcast/source/camera/camera_settings.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::sensor {

struct SourceOptions {
  source::Pace pace = source::Pace::kRealTime;
  bool loop = true;                        // recordings restart at their end
  double sim_fps = 15;                     // sim: frames per second
  int sim_sensor_count = 3;                // sim: number of sensors around the room
  std::uint64_t sim_seed = 1;              // sim: noise and furniture
  std::stop_token stop = {};               // ends the preparation of a sim, or waiting for ROS 2
  source::CameraSettings camera = {};      // cameras: requested settings
  std::filesystem::path calibration = {};  // camera.json that overrides the source
  LogSink log = {};  // cameras: connection lost or back; called from a thread of theirs
};

/// kInvalidArgument for a SPEC of unknown kind (the message lists the kinds); kUnsupported for a
/// kind of camera that this program was built without; else the errors of the kind and of
/// with_calibration.
[[nodiscard]] Result<std::unique_ptr<source::FrameSource>> open_source(
    const std::string& spec, const SourceOptions& options = {});

/// The recordings of other programs among `specs`, as sources of one room: their clocks are joined
/// (recording/import/room_timeline.h), and their names are unique.
struct RecordedRoom {
  std::vector<std::unique_ptr<source::FrameSource>> sources;  // as `specs`; null for other kinds
  std::string clock;  // what joined them, as the end of a sentence; empty for one or none
  std::vector<std::string> notes;  // of the recordings, as sentences
};

/// Errors of recording::open_sensor and recording::join_clocks.
[[nodiscard]] Result<RecordedRoom> open_recorded_room(const std::vector<std::string>& specs,
                                                      const SourceOptions& options,
                                                      recording::JoiningClock clock);

}  // namespace roomcast::sensor
