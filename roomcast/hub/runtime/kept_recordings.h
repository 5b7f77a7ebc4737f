// SPDX-License-Identifier: Apache-2.0
// KeptRecordings: the admin interface's view of the finished recordings on the hub's disk.
// Threading: called on the rooms' thread; no member may block. Answers come later, on any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/access/claims.h"
#include "roomcast/net/long_body.h"

namespace roomcast::hub {

enum class KeptState {
  kWhole,
  kRunning,     // it is being recorded
  kDamaged,     // its end is missing
  kUnreadable,  // it is no recording, or none that this version reads
};

[[nodiscard]] constexpr std::string_view name_of(KeptState state) {
  switch (state) {
    case KeptState::kWhole:
      return "whole";
    case KeptState::kRunning:
      return "running";
    case KeptState::kDamaged:
      return "damaged";
    case KeptState::kUnreadable:
      break;
  }
  return "unreadable";
}

struct KeptRecording {
  std::string name;  // of the file, without its ending
  std::string room;  // empty: unknown
  std::string by;    // who started it; empty: unknown
  KeptState state = KeptState::kWhole;
  std::string problem;  // why it is damaged or unreadable, as a sentence
  std::uint64_t bytes = 0;
  double seconds = 0;
  UnixSeconds began_at = 0;  // of an unreadable one: when the file was changed last
  std::size_t sensors = 0;
  bool has_voices = false;
};

struct RecordingList {
  std::vector<KeptRecording> recordings;  // newest first
  std::size_t left_out = 0;               // older ones, beyond the limit
  std::size_t unread = 0;                 // files that are still being looked at: ask again
};

/// A room's recordings, as far as this caller may know of them.
struct RecordingScope {
  std::string room;
  bool unknown_too = false;  // also files that do not say their room
};

/// Of a recording that is played: docs/spec/playback.md.
struct WantedPart {
  enum class Kind { kPart, kMoment, kKeyFrame };
  Kind kind = Kind::kPart;
  std::uint32_t number = 0;  // of the part, or milliseconds since the start
  std::string sensor{};      // of a key frame
};

template <class T>
using WhenKnown = std::function<void(Result<T>)>;

class KeptRecordings {
 public:
  virtual ~KeptRecordings() = default;

  virtual void list(RecordingScope scope, WhenKnown<RecordingList> done) = 0;
  // `name` is a KeptRecording's. kNotFound: there is none of that name in this scope. kUnavailable:
  // it is being recorded, or the disk refuses.
  virtual void about(RecordingScope scope, std::string name, WhenKnown<KeptRecording> done) = 0;
  /// Also what PlayableRecording returns.
  virtual void part(RecordingScope scope, std::string name, WantedPart wanted,
                    WhenKnown<std::shared_ptr<const std::string>> done) = 0;
  virtual void open(RecordingScope scope, std::string name,
                    WhenKnown<std::shared_ptr<const net::LongBody>> done) = 0;
  /// Also kInvalidArgument: `to` is no name for a file, or is in use.
  virtual void rename(RecordingScope scope, std::string name, std::string to,
                      WhenKnown<KeptRecording> done) = 0;
  virtual void remove(RecordingScope scope, std::string name, std::function<void(Status)> done) = 0;

  /// Returns when everything asked so far has been answered. Call when the hub ends.
  virtual void settle() = 0;
};

}  // namespace roomcast::hub
