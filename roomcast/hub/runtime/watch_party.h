// SPDX-License-Identifier: Apache-2.0
// WatchParties: people who play the same recording together: where each stands, and at which
// position all of them play (docs/spec/playback.md). Kept while they ask; nothing is stored. Pure.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"

namespace roomcast::hub {

/// How a recording is played.
struct Playing {
  double position_s = 0;
  bool paused = false;
  double speed = 1;
};

/// Of one page, as it says itself.
struct WatcherState {
  std::string key;           // random; tells pages apart, and is passed to nobody
  std::string name;          // may be empty
  std::uint32_t viewer = 0;  // by which its voice is known; 0: it has none
  std::array<float, 7> head = {0, 0, 0, 0, 0, 0, 1};  // x, y, z in metres, then a unit quaternion
  std::optional<Playing> wants = {};                  // this person has just sought, paused, ...
  bool leaves = false;                                // the page goes away
};

class WatchParties {
 public:
  static constexpr std::chrono::seconds kGoneAfter{5};
  static constexpr std::size_t kMaxWatchers = 64;  // of a recording
  static constexpr std::size_t kMaxParties = 64;

  struct Other {
    std::uint32_t id = 0;
    std::uint32_t viewer = 0;
    std::string name;
    std::array<float, 7> head{};
  };
  struct View {
    std::vector<Other> others;
    Playing playing;           // now
    std::uint64_t change = 0;  // counts what people wanted, from 1
    std::string by;            // who wanted it last
    bool is_own = false;       // the asking page did
  };

  /// Nothing: there are too many.
  std::optional<View> visit(const std::string& recording, WatcherState watcher, HostTime now);

 private:
  struct Watcher {
    WatcherState state;
    std::uint32_t id = 0;
    HostTime seen{};
  };
  struct Party {
    std::vector<Watcher> watchers;
    Playing playing;  // at `since`
    HostTime since{};
    std::uint64_t change = 0;
    std::uint32_t changed_by = 0;
    std::string by;
  };
  void forget_gone(HostTime now);

  std::map<std::string, Party> parties_;
  std::uint32_t next_id_ = 1;
};

}  // namespace roomcast::hub
