// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/recording_source.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <utility>

namespace roomcast {
namespace {

constexpr std::size_t kDepthValues = std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1;
constexpr double kMillimetresPerMetre = 1000;

bool already_mm(const RecordedCamera& camera) {
  const auto zero = [](std::uint16_t value) { return value == 0; };
  return camera.depth_scale_to_metre * kMillimetresPerMetre == 1.0 &&
         std::all_of(camera.invalid_depth.begin(), camera.invalid_depth.end(), zero);
}

/// What each value of the depth pictures means; 0 for invalid ones and for what does not fit.
std::vector<std::uint16_t> make_mm_from_value(const RecordedCamera& camera) {
  if (already_mm(camera)) return {};
  std::vector<std::uint16_t> mm_from_value(kDepthValues);
  for (std::size_t value = 0; value < kDepthValues; ++value) {
    const double mm =
        std::round(static_cast<double>(value) * camera.depth_scale_to_metre * kMillimetresPerMetre);
    const bool fits = mm <= std::numeric_limits<std::uint16_t>::max();
    mm_from_value[value] = fits ? static_cast<std::uint16_t>(mm) : std::uint16_t{0};
  }
  for (const std::uint16_t invalid : camera.invalid_depth) mm_from_value[invalid] = 0;
  return mm_from_value;
}

std::vector<nanoseconds> positions_of(const Recording& recording) {
  std::vector<nanoseconds> positions;
  for (const RecordedFrame& frame : recording.frames) {
    positions.push_back(frame.true_time - recording.start);
  }
  return positions;
}

/// False if `stop` came first.
bool wait_until(HostTime time, std::stop_token stop) {
  const std::chrono::steady_clock::time_point due(time.time_since_epoch());
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  never.wait_until(lock, stop, due, [] { return false; });
  return !stop.stop_requested();
}

ImageSize size_of(const CameraIntrinsics& camera) {
  return {camera.width, camera.height};
}

Result<std::unique_ptr<FrameSource>> play(Result<Recording> recording,
                                          const SourceOptions& options) {
  if (!recording.ok()) return recording.error();
  return std::unique_ptr<FrameSource>(
      std::make_unique<RecordingSource>(std::move(*recording), options, SteadyClock().now()));
}

}  // namespace

RecordingSource::RecordingSource(Recording recording, const SourceOptions& options, HostTime opened)
    : recording_(std::move(recording)),
      schedule_(positions_of(recording_), recording_.loop_duration, options.pace, options.loop,
                opened),
      pace_(options.pace),
      mm_from_value_(make_mm_from_value(recording_.camera)) {}

Result<bool> RecordingSource::next(CapturedFrame& frame, std::stop_token stop) {
  if (stop.stop_requested()) return false;
  const auto due = schedule_.next(SteadyClock().now());
  if (!due) return false;
  const RecordedFrame& recorded = recording_.frames[due->frame];
  if (Status status = read_pictures(recorded, frame); !status.ok()) return status.error();
  frame.index = recorded.index;
  frame.device_time = recorded.device_time;
  frame.capture_time = due->when;
  return pace_ == Pace::kAsFastAsPossible || wait_until(due->when, stop);
}

Status RecordingSource::read_pictures(const RecordedFrame& recorded, CapturedFrame& frame) {
  const SensorCalibration& calibration = recording_.description.calibration;
  Status status = reader_.read_depth(recorded.depth, size_of(calibration.depth), frame.depth_mm);
  if (!status.ok()) return status;
  if (!mm_from_value_.empty()) {
    std::uint16_t* const values = frame.depth_mm.data();
    for (std::size_t i = 0; i < frame.depth_mm.view().pixel_count(); ++i) {
      values[i] = mm_from_value_[values[i]];
    }
  }
  if (recorded.color.empty()) {
    frame.color = {};
    return {};
  }
  return reader_.read_color(recorded.color, size_of(calibration.color), frame.color);
}

Result<std::unique_ptr<FrameSource>> open_rig_source(const std::string& directory,
                                                     const std::string& sensor,
                                                     const SourceOptions& options) {
  return play(read_rig_recording(directory, sensor), options);
}

Result<std::unique_ptr<FrameSource>> open_tum_source(const std::string& directory,
                                                     const SourceOptions& options) {
  return play(read_tum_recording(directory), options);
}

}  // namespace roomcast
