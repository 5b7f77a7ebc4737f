// SPDX-License-Identifier: Apache-2.0
// RecordingSource: plays a recorded sensor as if it were a live one. `device_time` is the recorded
// timestamp; `capture_time` is the time at which the frame is due on this host's clock
// (playback_schedule.h). Pictures are decoded ahead and returned when they are due.
// Single-threaded.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "roomcast/io/depth_values.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/recording.h"
#include "roomcast/recording/playback/playback_schedule.h"

namespace roomcast::recording {

class RecordingSource final : public source::FrameSource {
 public:
  RecordingSource(Recording recording, const source::PlaybackOptions& options, HostTime opened);

  [[nodiscard]] const source::SensorDescription& description() const override {
    return recording_.description;
  }
  /// After an error (kNotFound, kMalformed, kTooLarge: a picture file is missing or damaged)
  /// playback continues with the next frame.
  [[nodiscard]] Result<bool> next(source::CapturedFrame& frame, std::stop_token stop) override;

 private:
  [[nodiscard]] Status read_pictures(const RecordedFrame& recorded, source::CapturedFrame& frame);

  Recording recording_;
  PlaybackSchedule schedule_;
  source::Pace pace_;
  io::ImageFileReader reader_;
  io::DepthValues depth_values_;
};

/// Opens a sensor of a rig folder. Errors of read_rig_recording.
[[nodiscard]] Result<std::unique_ptr<source::FrameSource>> open_rig_source(
    const std::string& directory, const std::string& sensor,
    const source::PlaybackOptions& options);
/// Opens a folder in TUM RGB-D layout. Errors of read_tum_recording.
[[nodiscard]] Result<std::unique_ptr<source::FrameSource>> open_tum_source(
    const std::string& directory, const source::PlaybackOptions& options);

}  // namespace roomcast::recording
