// SPDX-License-Identifier: Apache-2.0
// Recorder: joins a hub as a viewer and writes the messages it receives, byte for byte, to a file
// (docs/spec/recording.md). Frames are written on the network thread: a slow disk slows down
// reading, and the hub then skips whole sets for this client; a full disk ends the recording, but
// does not affect the room. Memory: one chunk.
// Threading: thread-safe.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "roomcast/client/credential.h"
#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/room/room_recording_writer.h"

namespace roomcast::recording {

struct RecorderOptions {
  std::string hub_url;
  std::string room;  // empty: the hub's only room
  client::Credential credential = {};
  bool voices = true;    // also people's voices, where the owner of the room permits it
  bool bundles = false;  // also record calibration bundles, for placing; needs an admin token
  std::filesystem::path path;
  std::string by = {};  // who started it, for the file; may be empty
  LogSink log;
  std::stop_token stop = {};  // ends the wait of open() for the hub
  /// How often the newest chunk is looked at, which goes to disk at kLongestChunk.
  nanoseconds look_after_chunk = RoomRecordingWriter::kLongestChunk / 2;
};

struct RecorderStats {
  std::uint64_t frames = 0;
  std::uint64_t frame_bytes = 0;  // as the hub sent them
  std::uint64_t file_bytes = 0;
  std::uint64_t voice_packets = 0;
};

class Recorder {
 public:
  /// Joins, then creates the file, which is marked if the room may not be exported.
  /// kInvalidArgument: not a hub's address. kUnavailable, kNotFound, kUnsupported, kClosed: the
  /// connection failed, the hub refused, or the file cannot be created.
  static Result<std::unique_ptr<Recorder>> open(RecorderOptions options);
  /// Calls finish() unless it was called already.
  ~Recorder();

  /// Leaves the room and writes the end of the file; call once. Returns the disk error, if there
  /// was one.
  Status finish();

  /// Reason why recording ended before finish(): a full disk, or the hub's refusal. A hub that is
  /// temporarily unreachable does not end it.
  [[nodiscard]] std::optional<Error> failure() const;
  [[nodiscard]] RecorderStats stats() const;
  [[nodiscard]] std::string room() const;

 private:
  class Link;
  explicit Recorder(std::unique_ptr<Link> link);
  std::unique_ptr<Link> link_;
};

}  // namespace roomcast::recording
