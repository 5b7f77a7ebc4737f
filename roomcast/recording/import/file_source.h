// SPDX-License-Identifier: Apache-2.0
// FileSource: plays a SensorFile as if its sensor were live, on a room's timeline
// (playback_schedule.h). `device_time` is the recorded one, `capture_time` the time at which the
// frame is due on this host's clock. Single-threaded.
#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "roomcast/recording/import/room_timeline.h"
#include "roomcast/recording/import/sensor_file.h"
#include "roomcast/recording/playback/playback_schedule.h"

namespace roomcast::recording {

class FileSource final : public source::FrameSource {
 public:
  /// `clock_offset`: device time minus room time, an entry of `timeline.clock_offsets`.
  FileSource(std::unique_ptr<SensorFile> file, std::string name, const RoomTimeline& timeline,
             nanoseconds clock_offset, const source::PlaybackOptions& options, HostTime opened);

  [[nodiscard]] const source::SensorDescription& description() const override {
    return description_;
  }
  /// After an error (a picture is damaged) playback continues with the next frame.
  [[nodiscard]] Result<bool> next(source::CapturedFrame& frame, std::stop_token stop) override;

 private:
  std::unique_ptr<SensorFile> file_;
  source::SensorDescription description_;
  PlaybackSchedule schedule_;
  source::Pace pace_;
};

struct PlayedRoom {
  std::vector<std::unique_ptr<source::FrameSource>> sources;
  std::string clock;  // what joined them: RoomTimeline::explanation
};

/// Sources of the sensors of one room, in the same order, with unique names. Errors of join_clocks.
[[nodiscard]] Result<PlayedRoom> play_together(std::vector<std::unique_ptr<SensorFile>> files,
                                               const source::PlaybackOptions& options,
                                               JoiningClock clock = JoiningClock::kAutomatic);

}  // namespace roomcast::recording
