// SPDX-License-Identifier: Apache-2.0
// GoneSurfaces: notices by a sensor's CoarseDepth that something which stood in its view stands
// there no longer, and counts the key frames that the room's model needs to forget it. Something
// that comes between, as a person who walks past, makes the near and the far distance of a cell
// shorter or leaves them, so a distance that has become longer means that a surface has gone.
// Pure; single-threaded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// StillView (roomcast/model/) forgets a surface when so many key frames see through it.
inline constexpr int kKeysToForget = 3;

class GoneSurfaces {
 public:
  /// The sensor's newest one. True: something large has gone since the one before. At most every
  /// 10 s, whatever the sensor says.
  bool update(const wire::pb::CoarseDepth& depth, RoomTime now);
  /// Another sensor has seen something large go. This one may have seen a part of it that changes
  /// the distances of no cell: what is nearest and farthest there is something else.
  void expect_changes() { expected_keys_ = kKeysToForget; }
  void key_frame_came(RoomTime now);
  /// True: a key frame that were sent now would help the model to forget something.
  [[nodiscard]] bool wants_key(RoomTime now) const;

 private:
  struct Cell {
    std::uint32_t near_cm = 0, far_cm = 0;          // of what stands there; 0: nothing is known
    std::uint32_t new_near_cm = 0, new_far_cm = 0;  // of the newest report
    std::optional<RoomTime> nearer_since = {};      // something stands before it, or comes past
    bool has_gone = false;
    int keys = 0;  // that have come since it has
  };
  static void take(Cell& cell, RoomTime now);

  std::uint32_t columns_ = 0;
  std::vector<Cell> cells_;
  std::optional<RoomTime> last_key_, last_large_;
  std::size_t gone_cells_ = 0;
  int expected_keys_ = 0;
};

}  // namespace roomcast::hub
