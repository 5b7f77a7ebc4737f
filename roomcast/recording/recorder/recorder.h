// SPDX-License-Identifier: Apache-2.0
// Recorder: keeps what a hub sends its viewers, the same bytes, in a file
// (docs/spec/recording.md). A client of the hub like any other. Frames are written on the network's
// thread: a disk that is too slow reads more slowly, and the hub then leaves out whole sets for it;
// one that is full ends the recording, not the room. Memory: one chunk.
// Threading: thread-safe.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "roomcast/client/credential.h"
#include "roomcast/core/log.h"
#include "roomcast/core/result.h"

namespace roomcast::recording {

struct RecorderOptions {
  std::string hub_url;
  std::string room;  // empty: the hub's only one
  client::Credential credential = {};
  bool bundles = false;  // kept, too: what sensors can be placed by; takes an admin's token
  std::filesystem::path path;
  LogSink log;
};

struct RecorderStats {
  std::uint64_t frames = 0;
  std::uint64_t frame_bytes = 0;  // as the hub sent them
  std::uint64_t file_bytes = 0;
};

class Recorder {
 public:
  /// Joins, then makes the file, which says so where the room may not be exported.
  /// kInvalidArgument: not a hub's address. kUnavailable, kNotFound,
  /// kUnsupported, kClosed: why there is no connection, why the hub refuses, or why the file cannot
  /// be made.
  static Result<std::unique_ptr<Recorder>> open(RecorderOptions options);
  /// As finish(), for what that has not done.
  ~Recorder();

  /// Leaves the room and writes the file's end; once. The error of the disk, if it had one.
  Status finish();

  /// Why it is over before finish(), once it is: a full disk, or the hub's refusal. A hub that is
  /// away for a while is no reason.
  [[nodiscard]] std::optional<Error> failure() const;
  [[nodiscard]] RecorderStats stats() const;
  [[nodiscard]] std::string room() const;

 private:
  class Link;
  explicit Recorder(std::unique_ptr<Link> link);
  std::unique_ptr<Link> link_;
};

}  // namespace roomcast::recording
