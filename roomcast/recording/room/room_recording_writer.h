// SPDX-License-Identifier: Apache-2.0
// RoomRecordingWriter: writes the messages that a hub sends its viewers, byte for byte, to an MCAP
// file (docs/spec/recording.md). Log times are arrival times, publish times are capture times, both
// in nanoseconds since 1970 as far as the caller knows. A chunk is closed after kLongestChunk at
// the latest, so a killed program loses no more than that. Memory: one chunk. Single-threaded.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/mcap/writer.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::recording {

/// Offset of a room's clock from the time of day.
struct RoomClock {
  nanoseconds unix_minus_room{};
  nanoseconds error{};  // of the recorder's estimate of room time
};

class RoomRecordingWriter {
 public:
  static constexpr std::chrono::milliseconds kLongestChunk{500};

  /// `by`: who started it; may be empty. kUnavailable if the file exists already or cannot be
  /// created.
  static Result<RoomRecordingWriter> create(const std::filesystem::path& path,
                                            const std::string& room, const std::string& by = "");

  /// Marks the whole file as not to be exported, including messages added earlier.
  [[nodiscard]] Status forbid_export();

  // Each of these fails with kUnavailable on a disk error: see
  // recording::mcap::Writer::add_message.
  [[nodiscard]] Status add_clock(const RoomClock& clock, nanoseconds log_time);
  [[nodiscard]] Status add_roster(const wire::pb::Roster& roster, nanoseconds log_time);
  [[nodiscard]] Status add_poses(const wire::pb::ViewerPoses& poses, nanoseconds log_time);
  [[nodiscard]] Status add_marks(const wire::pb::Marks& marks, nanoseconds log_time);
  /// Bundles of sensors that are not in the last roster are ignored.
  [[nodiscard]] Status add_bundle(const wire::pb::CalibrationBundle& bundle, nanoseconds log_time);
  /// `message`: frame message with header. Frames of sensors not in the last roster, or of
  /// impossible times, are ignored.
  [[nodiscard]] Status add_frame(std::span<const std::uint8_t> message, nanoseconds log_time);

  /// `message`: audio packet with header. Others, and those of impossible times, are ignored.
  [[nodiscard]] Status add_voice(std::span<const std::uint8_t> message, nanoseconds log_time);

  /// Must be called regularly, also while no messages arrive.
  [[nodiscard]] Status close_old_chunk(nanoseconds now);
  [[nodiscard]] Status finish();

  [[nodiscard]] std::uint64_t bytes() const { return writer_.bytes(); }
  /// Frames in the file and in the newest chunk, which a disk error can still take away.
  [[nodiscard]] std::uint64_t frames() const { return written_.frames + in_chunk_.frames; }
  [[nodiscard]] std::uint64_t frame_bytes() const { return written_.bytes + in_chunk_.bytes; }
  /// Likewise.
  [[nodiscard]] std::uint64_t voice_packets() const { return written_.voices + in_chunk_.voices; }

 private:
  struct Stream {
    recording::mcap::ChannelId channel{};
    std::uint32_t next_sequence = 0;
  };
  struct Schemas {
    recording::mcap::SchemaId frame, roster, poses, marks, voice, bundle, clock;
  };

  struct Counts {
    std::uint64_t frames = 0, bytes = 0, voices = 0;
  };

  /// Counts the messages of a chunk that was just written, or was lost (`status`).
  Status settle_chunk(Status status);
  RoomRecordingWriter(recording::mcap::Writer writer, std::string room, const std::string& by);
  Stream& stream(std::string_view topic, recording::mcap::SchemaId schema,
                 std::string_view encoding, recording::mcap::StringMap metadata = {});
  Status add(Stream& stream, std::span<const std::uint8_t> data, nanoseconds log_time,
             nanoseconds publish_time);
  Status add(Stream& stream, const google::protobuf::MessageLite& message, nanoseconds log_time);

  recording::mcap::Writer writer_;
  recording::mcap::StringMap about_;
  Schemas schemas_;
  RoomClock clock_;
  std::map<std::string, Stream> streams_;  // by topic
  std::map<std::uint32_t, std::string> sensors_;
  std::map<std::uint32_t, Stream*> frame_streams_;  // of the sensors in the last roster
  nanoseconds chunk_began_{};
  Counts written_, in_chunk_;
  std::string scratch_;
};

}  // namespace roomcast::recording
