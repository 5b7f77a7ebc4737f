// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/playback/recording_source.h"

#include <chrono>
#include <utility>

#include "roomcast/core/interruptible_wait.h"

namespace roomcast::recording {
namespace {

std::vector<nanoseconds> positions_of(const Recording& recording) {
  std::vector<nanoseconds> positions;
  for (const RecordedFrame& frame : recording.frames) {
    positions.push_back(frame.true_time - recording.start);
  }
  return positions;
}

io::ImageSize size_of(const CameraIntrinsics& camera) {
  return {camera.width, camera.height};
}

Result<std::unique_ptr<source::FrameSource>> play(Result<Recording> recording,
                                                  const source::PlaybackOptions& options) {
  if (!recording.ok()) return recording.error();
  return std::unique_ptr<source::FrameSource>(
      std::make_unique<RecordingSource>(std::move(*recording), options, SteadyClock().now()));
}

}  // namespace

RecordingSource::RecordingSource(Recording recording, const source::PlaybackOptions& options,
                                 HostTime opened)
    : recording_(std::move(recording)),
      schedule_(positions_of(recording_), recording_.loop_duration, options.pace, options.loop,
                opened),
      pace_(options.pace),
      depth_values_(recording_.camera) {}

Result<bool> RecordingSource::next(source::CapturedFrame& frame, std::stop_token stop) {
  if (stop.stop_requested()) return false;
  const auto due = schedule_.next(SteadyClock().now());
  if (!due) return false;
  const RecordedFrame& recorded = recording_.frames[due->frame];
  if (Status status = read_pictures(recorded, frame); !status.ok()) return status.error();
  frame.index = recorded.index;
  frame.device_time = recorded.device_time;
  frame.capture_time = due->when;
  return pace_ == source::Pace::kAsFastAsPossible || wait_until(due->when, stop);
}

Status RecordingSource::read_pictures(const RecordedFrame& recorded, source::CapturedFrame& frame) {
  const SensorCalibration& calibration = recording_.description.calibration;
  Status status = reader_.read_depth(recorded.depth, size_of(calibration.depth), frame.depth_mm);
  if (!status.ok()) return status;
  depth_values_.to_mm(frame.depth_mm);
  if (recorded.color.empty()) {
    frame.color = {};
    return {};
  }
  return reader_.read_color(recorded.color, size_of(calibration.color), frame.color);
}

Result<std::unique_ptr<source::FrameSource>> open_rig_source(
    const std::string& directory, const std::string& sensor,
    const source::PlaybackOptions& options) {
  return play(read_rig_recording(directory, sensor), options);
}

Result<std::unique_ptr<source::FrameSource>> open_tum_source(
    const std::string& directory, const source::PlaybackOptions& options) {
  return play(read_tum_recording(directory), options);
}

}  // namespace roomcast::recording
