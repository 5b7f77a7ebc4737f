// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/file_source.h"

#include <utility>

#include "roomcast/core/interruptible_wait.h"
#include "roomcast/recording/import/sensor_name.h"

namespace roomcast::recording {
namespace {

std::vector<nanoseconds> positions_on(const RoomTimeline& timeline, const SensorFileInfo& info,
                                      nanoseconds clock_offset) {
  std::vector<nanoseconds> positions;
  positions.reserve(info.times.size());
  for (const nanoseconds time : info.times)
    positions.push_back(time - clock_offset - timeline.start);
  return positions;
}

}  // namespace

FileSource::FileSource(std::unique_ptr<SensorFile> file, std::string name,
                       const RoomTimeline& timeline, nanoseconds clock_offset,
                       const source::PlaybackOptions& options, HostTime opened)
    : file_(std::move(file)),
      description_(file_->info().description),
      schedule_(positions_on(timeline, file_->info(), clock_offset), timeline.loop_duration,
                options.pace, options.loop, opened),
      pace_(options.pace) {
  description_.name = std::move(name);
}

Result<bool> FileSource::next(source::CapturedFrame& frame, std::stop_token stop) {
  if (stop.stop_requested()) return false;
  const auto due = schedule_.next(SteadyClock().now());
  if (!due) return false;
  if (Status status = file_->read_depth(due->frame, frame.depth_mm); !status) return status.error();
  if (Status status = file_->read_color(due->frame, frame.color); !status) return status.error();
  frame.index = due->frame;
  frame.device_time = file_->info().times[due->frame];
  frame.capture_time = due->when;
  return pace_ == source::Pace::kAsFastAsPossible || wait_until(due->when, stop);
}

Result<PlayedRoom> play_together(std::vector<std::unique_ptr<SensorFile>> files,
                                 const source::PlaybackOptions& options, JoiningClock clock) {
  std::vector<const SensorFileInfo*> infos;
  std::vector<std::string> names;
  for (const auto& file : files) {
    infos.push_back(&file->info());
    names.push_back(file->info().description.name);
  }
  make_unique(names);
  const auto timeline = join_clocks(infos, clock);
  if (!timeline) return timeline.error();
  const HostTime opened = SteadyClock().now();
  PlayedRoom room{{}, timeline->explanation};
  for (std::size_t i = 0; i < files.size(); ++i) {
    room.sources.push_back(std::make_unique<FileSource>(std::move(files[i]), std::move(names[i]),
                                                        *timeline, timeline->clock_offsets[i],
                                                        options, opened));
  }
  return room;
}

}  // namespace roomcast::recording
