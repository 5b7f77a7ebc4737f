// SPDX-License-Identifier: Apache-2.0
// RoomRecording: a recording of a room, opened: which sensors it has, where they stood, how long it
// is (docs/spec/recording.md). A damaged one is read up to the damage. Times are nanoseconds since
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

/// What the room was from a moment on.
struct RecordedRoster {
  nanoseconds time{};
  wire::pb::Roster roster;
};

struct RecordedSensor {
  std::string name;
  recording::mcap::ChannelId frames_channel{};
  std::uint64_t frame_count = 0;
  wire::pb::SensorEntry entry;  // of the last roster that has it
};

/// Times that can be added and subtracted without harm: until 2043, or as long after a machine's
/// start.
[[nodiscard]] constexpr bool is_plausible(nanoseconds time) {
  constexpr std::int64_t kFarthest = std::int64_t{1} << 61;
  return time.count() > -kFarthest && time.count() < kFarthest;
}

enum class MessageKind { kFrame, kRoster, kPoses, kBundle, kClock, kOther };

class RoomRecording {
 public:
  /// kNotFound; kMalformed when it is no MCAP file; kUnsupported when it is one, but of no room, or
  /// of a later version.
  static Result<RoomRecording> open(const std::filesystem::path& path);
  static Result<RoomRecording> from(recording::mcap::Reader reader);

  [[nodiscard]] const std::string& room() const { return room_; }
  [[nodiscard]] nanoseconds start() const { return file_.summary().statistics.start_time; }
  [[nodiscard]] nanoseconds end() const { return file_.summary().statistics.end_time; }
  /// When the first frame was taken: a little before start(), when it came.
  [[nodiscard]] nanoseconds origin() const { return origin_; }
  /// Those that sent frames, by name.
  [[nodiscard]] const std::vector<RecordedSensor>& sensors() const { return sensors_; }
  /// Null when there is none of that name.
  [[nodiscard]] const RecordedSensor* sensor(const std::string& name) const;
  /// In order. A sensor that was placed later on has its pose here from the beginning.
  [[nodiscard]] const std::vector<RecordedRoster>& rosters() const { return rosters_; }
  /// That of a moment; before all, the first. At least one is there.
  [[nodiscard]] const wire::pb::Roster& roster_at(nanoseconds time) const;
  /// False: who recorded it was not let export the room.
  [[nodiscard]] bool may_be_exported() const { return may_be_exported_; }
  /// Why its end is missing, in a sentence; nothing when it is whole.
  [[nodiscard]] const std::optional<std::string>& damage() const { return file_.damage(); }

  [[nodiscard]] const recording::mcap::Reader& file() const { return file_; }
  [[nodiscard]] MessageKind kind_of(recording::mcap::ChannelId channel) const;

  /// From which chunk on one has to read to decode these sensors' frames at `time`: the one with
  /// the last key frame before, of the sensor whose key frame is oldest.
  [[nodiscard]] std::size_t chunk_to_decode_from(nanoseconds time,
                                                 std::span<const RecordedSensor> sensors) const;

 private:
  explicit RoomRecording(recording::mcap::Reader file) : file_(std::move(file)) {}
  Status read_about();
  Status read_rosters();
  [[nodiscard]] Status check_times() const;
  void find_origin();
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
