// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/frame_sets/recorded_sets.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "roomcast/client/room/calibration_message.h"
#include "roomcast/client/room/room_state.h"
#include "roomcast/codec/depth_grid_color.h"
#include "roomcast/core/clock.h"
#include "roomcast/recording/room/recording_cursor.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::recording {
namespace {

using recording::MessageKind;
using recording::RecordedMessage;
using recording::RecordingCursor;
using recording::RoomRecording;

class RecordedSets final : public FrameSetReader {
 public:
  RecordedSets(RoomRecording recording, std::vector<SetSensor> sensors, nanoseconds from)
      : recording_(std::move(recording)),
        sensors_(std::move(sensors)),
        from_(from),
        cursor_(recording_,
                recording_.chunk_to_decode_from(recording_.origin() + from, recording_.sensors())) {
    for (std::size_t i = 0; i < sensors_.size(); ++i) index_of_[sensors_[i].name] = i;
    (void)state_.roster(recording_.roster_at(recording_.origin() + from));
  }

  const std::vector<SetSensor>& sensors() const override { return sensors_; }
  nanoseconds length() const override { return recording_.end() - recording_.origin(); }
  nanoseconds began_at() const override { return recording_.origin(); }
  std::optional<std::string> damage() const override { return recording_.damage(); }
  bool may_be_exported() const override { return recording_.may_be_exported(); }

  Result<bool> next(FrameSet& set) override {
    RecordedMessage recorded;
    for (;;) {
      const auto more = cursor_.next(recorded);
      if (!more) return more.error();
      const bool complete = *more ? take(recorded, set) : close_set(set);
      if (complete && set.time >= from_) {
        set.number = count_++;
        return true;
      }
      if (!*more) return false;
    }
  }

 private:
  /// Returns true if the message completed a set.
  bool take(const RecordedMessage& recorded, FrameSet& set) {
    if (recorded.kind == MessageKind::kRoster)
      (void)state_.roster(recording_.roster_at(recorded.message.log_time));
    if (recorded.kind != MessageKind::kFrame) return false;
    const auto header = wire::parse_frame(recorded.message.data);
    if (!header) return false;
    const bool before = open_set_ != header->set && close_set(set);
    open_set_ = header->set;
    unix_minus_room_ = recorded.message.publish_time - header->capture_time.time_since_epoch();
    const auto outcome = state_.frame(recorded.message.data);
    has_frames_ |= outcome && *outcome != client::RoomState::FrameOutcome::kNeedsKey;
    if (before) return true;
    return header->last && close_set(set);
  }

  bool close_set(FrameSet& set) {
    if (!std::exchange(has_frames_, false)) return false;
    const auto room = state_.snapshot();
    set.frames.clear();
    set.time = {};
    for (const client::RoomSensor& sensor : room->sensors) add(sensor, set);
    std::ranges::sort(set.frames, {}, &SetFrame::sensor);
    std::erase_if(set.frames,
                  [&](const SetFrame& frame) { return set.time - frame.time > kOldestInSet; });
    return !set.frames.empty();
  }

  void add(const client::RoomSensor& sensor, FrameSet& set) {
    const auto index = index_of_.find(sensor.name);
    if (index == index_of_.end() || !sensor.picture) return;
    SetFrame frame;
    frame.sensor = index->second;
    frame.pictures = codec::with_color_in_depth_grid({sensor.picture, &sensor.picture->frame});
    if (sensor.pose.is_placed()) frame.world_from_depth = sensor.pose.world_from_depth;
    frame.time =
        sensor.picture->capture_time.time_since_epoch() + unix_minus_room_ - recording_.origin();
    set.time = std::max(set.time, frame.time);
    set.frames.push_back(std::move(frame));
  }

  const RoomRecording recording_;
  const std::vector<SetSensor> sensors_;
  const nanoseconds from_;
  std::map<std::string, std::size_t> index_of_;
  RecordingCursor cursor_;
  SteadyClock clock_;  // RoomState needs one; the arrival times are not used
  client::RoomState state_{clock_};
  nanoseconds unix_minus_room_{};
  SetId open_set_{};
  bool has_frames_ = false;  // in the open set
  std::uint64_t count_ = 0;
};

}  // namespace

Result<std::unique_ptr<FrameSetReader>> open_recorded_sets(const std::filesystem::path& file,
                                                           nanoseconds from) {
  auto recording = RoomRecording::open(file);
  if (!recording) return recording.error();
  std::vector<SetSensor> sensors;
  for (const auto& sensor : recording->sensors()) {
    const auto calibration = client::calibration_from_message(sensor.entry.calibration());
    if (!calibration) return calibration.error();
    sensors.push_back({sensor.name, calibration->depth, sensor.entry.fps(),
                       0.001 * static_cast<double>(sensor.entry.expected_error_mm())});
  }
  return std::unique_ptr<FrameSetReader>(
      std::make_unique<RecordedSets>(std::move(*recording), std::move(sensors), from));
}

}  // namespace roomcast::recording
