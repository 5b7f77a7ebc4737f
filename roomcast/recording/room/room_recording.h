// SPDX-License-Identifier: Apache-2.0
// RoomRecording: an opened recording of a room: its sensors, their poses and its duration
// (docs/spec/recording.md). A damaged file is read up to the damage. Times are nanoseconds since
// 1970, as recorded. Immutable: any number of threads may read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/mcap/reader.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::recording {

/// The roster that is in effect from `time` on.
struct RecordedRoster {
  nanoseconds time{};
  wire::pb::Roster roster;
};

struct RecordedSensor {
  std::string name;
  recording::mcap::ChannelId frames_channel{};
  std::uint64_t frame_count = 0;
  wire::pb::SensorEntry entry;  // from the last roster that contains the sensor
};

/// True for times that can be added and subtracted without overflow: up to the year 2043, or
/// equally long after a machine's start.
[[nodiscard]] constexpr bool is_plausible(nanoseconds time) {
  constexpr std::int64_t kFarthest = std::int64_t{1} << 61;
  return time.count() > -kFarthest && time.count() < kFarthest;
}

enum class MessageKind { kFrame, kRoster, kPoses, kMarks, kVoice, kBundle, kClock, kOther };

class RoomRecording;

/// kUnavailable, with a sentence, if the recording may not be exported.
[[nodiscard]] Status check_may_be_exported(const RoomRecording& recording);
[[nodiscard]] Error export_is_not_allowed();

class RoomRecording {
 public:
  /// kNotFound; kMalformed if the file is not MCAP; kUnsupported if it is MCAP but not a recorded
  /// room, or is of a later version.
  static Result<RoomRecording> open(const std::filesystem::path& path);
  static Result<RoomRecording> from(recording::mcap::Reader reader);

  [[nodiscard]] const std::string& room() const { return room_; }
  [[nodiscard]] nanoseconds start() const { return file_.summary().statistics.start_time; }
  [[nodiscard]] nanoseconds end() const { return file_.summary().statistics.end_time; }
  /// Capture time of the first frame: slightly before start(), which is its arrival time.
  [[nodiscard]] nanoseconds origin() const { return origin_; }
  /// The sensors that sent frames, sorted by name.
  [[nodiscard]] const std::vector<RecordedSensor>& sensors() const { return sensors_; }
  /// Null if no sensor has that name.
  [[nodiscard]] const RecordedSensor* sensor(const std::string& name) const;
  /// In order of time. A sensor that was placed later has its pose here from the beginning.
  [[nodiscard]] const std::vector<RecordedRoster>& rosters() const { return rosters_; }
  /// The roster in effect at `time`; before the first one, the first. There is at least one; that
  /// of a recording that ended before the hub's first list has no sensors.
  [[nodiscard]] const wire::pb::Roster& roster_at(nanoseconds time) const;
  /// False if the recorder was not permitted to export the room.
  [[nodiscard]] bool may_be_exported() const { return may_be_exported_; }
  /// Reason why the end of the file is missing, as a sentence; nothing if the file is complete.
  [[nodiscard]] const std::optional<std::string>& damage() const { return file_.damage(); }

  [[nodiscard]] const recording::mcap::Reader& file() const { return file_; }
  [[nodiscard]] MessageKind kind_of(recording::mcap::ChannelId channel) const;

  /// Index of the chunk to start reading at in order to decode these sensors' frames at `time`: the
  /// chunk with the last key frame before `time` of the sensor whose key frame is oldest.
  [[nodiscard]] std::size_t chunk_to_decode_from(nanoseconds time,
                                                 std::span<const RecordedSensor> sensors) const;

 private:
  explicit RoomRecording(recording::mcap::Reader file) : file_(std::move(file)) {}
  Status read_about();
  Status read_rosters();
  void find_origin();
  [[nodiscard]] bool has_frames() const;
  void find_sensors();
  void place_from_the_beginning();

  recording::mcap::Reader file_;
  std::string room_;
  bool may_be_exported_ = true;
  nanoseconds origin_{};
  std::vector<RecordedSensor> sensors_;
  std::vector<RecordedRoster> rosters_;
};

}  // namespace roomcast::recording
