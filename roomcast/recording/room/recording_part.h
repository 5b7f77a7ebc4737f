// SPDX-License-Identifier: Apache-2.0
// Parts of a recording for players that fetch it piece by piece: docs/spec/playback.md. A part is
// built from the file alone, so whoever serves it keeps no state for a player. Threading:
// immutable; any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/recording/room/room_recording.h"

namespace roomcast::recording {

inline constexpr std::uint32_t kPartMagic = 0x54504352;  // "RCPT"
inline constexpr std::uint16_t kPartVersion = 1;
inline constexpr std::size_t kPartHeaderBytes = 32;
inline constexpr std::size_t kPartRecordHeaderBytes = 16;
inline constexpr std::uint32_t kNoPart = 0xFFFFFFFF;

/// How far back the frames are sought that a moment's picture needs. Sensors whose key frame is
/// older appear at their next one.
inline constexpr std::chrono::seconds kMaxLookBack{30};
inline constexpr std::uint64_t kMaxLookBackBytes = 128U << 20U;
/// A part ends with the chunk that reaches one of these.
inline constexpr std::chrono::milliseconds kPartLength{1000};
inline constexpr std::size_t kPartBytes = 4U << 20U;

class PlayableRecording {
 public:
  /// Errors as RoomRecording::open.
  static Result<PlayableRecording> open(const std::filesystem::path& path);

  /// All that is needed to show the room at `time` after the start, and what follows to the end of
  /// a chunk. A time beyond the end is the end.
  [[nodiscard]] std::string moment(nanoseconds time) const;
  /// What follows from a chunk on: `next` of another part. kNotFound: there is no such chunk.
  [[nodiscard]] Result<std::string> part(std::uint32_t chunk) const;
  /// For a small picture of `time`: a part with the last key frame of this sensor before it, or, at
  /// the sensor's beginning, one that follows. Without a record where neither is near, or there is
  /// no such sensor.
  [[nodiscard]] std::string key_frame(std::string_view sensor, nanoseconds time) const;

 private:
  struct Change {
    nanoseconds time{};
    wire::pb::Marks marks;
  };
  struct Found {
    nanoseconds time{};
    std::vector<std::uint8_t> message;
  };
  class Builder;

  explicit PlayableRecording(RoomRecording recording) : recording_(std::move(recording)) {}
  void read_marks();
  [[nodiscard]] std::vector<wire::pb::Control> marks_at(nanoseconds time) const;
  [[nodiscard]] std::size_t chunk_at(nanoseconds time) const;
  [[nodiscard]] nanoseconds within(nanoseconds since_start) const;
  [[nodiscard]] std::optional<Found> key_frame_in(std::size_t chunk, mcap::ChannelId frames,
                                                  nanoseconds from, nanoseconds until) const;
  void add_past(nanoseconds time, std::size_t chunk, Builder& part) const;
  void add_chunk(std::size_t chunk, nanoseconds after, Builder& part) const;

  RoomRecording recording_;
  std::vector<Change> marks_;  // in order of time
};

}  // namespace roomcast::recording
