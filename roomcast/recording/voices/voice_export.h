// SPDX-License-Identifier: Apache-2.0
// Exports the voices of a recorded room as WAV files: all in one, and each person in one. All files
// begin at the same instant and have the same length, so that programs can lay them side by side.
// voices.csv lists them. Single-threaded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/recording/room/room_recording.h"

namespace roomcast::recording {

struct VoiceExportOptions {
  /// Where the listener is at a time since the recording began: x right, y up, -z ahead.
  using Listener = std::function<RigidTransform(nanoseconds)>;

  std::filesystem::path out;  // folder
  nanoseconds from{};         // since the recording began
  nanoseconds to{};           // 0: to the end
  bool per_person = false;    // also a file for each person
  Listener listener = {};     // of a file in stereo; none: one channel, all are equally loud
  /// Called now and then with the time that was reached.
  std::function<void(nanoseconds)> progress = {};
  std::stop_token stop = {};
};

/// One person from joining to leaving.
struct ExportedVoice {
  std::string person;  // name; "viewer N" for somebody without one
  std::uint32_t viewer = 0;
  std::filesystem::path file;      // empty without `per_person`
  double first_s = 0, last_s = 0;  // begin of the first and end of the last packet, in the files
  double speech_s = 0;
  std::uint64_t concealed = 0;  // packets that are lost or broken
};

struct VoiceExport {
  std::vector<std::filesystem::path> files;
  std::vector<ExportedVoice> people;
  double seconds = 0;               // length of each file
  nanoseconds began_at{};           // of the files, since 1970-01-01 UTC
  std::uint64_t damaged_parts = 0;  // of the recording, which were left out
};

/// kNotFound: nobody is heard in that part of the recording. kTooLarge: more than a WAV file holds,
/// or too many people. kUnavailable: the room may not be exported, or a file exists or cannot be
/// written. kClosed: interrupted; no file is left.
[[nodiscard]] Result<VoiceExport> export_voices(const RoomRecording& recording,
                                                const VoiceExportOptions& options);

}  // namespace roomcast::recording
