// SPDX-License-Identifier: Apache-2.0
// PlaybackSchedule: determines which frame of a recording comes next, and when. Arithmetic only:
// the caller supplies the time.
// A looping recording is played as if it had begun when the host's clock began: the frame at
// position p is due at p + k * loop_duration for every whole k. So sources opened at different
// times, in different processes, show the same instants of the room. Played once, a recording
// begins when it is opened. As fast as possible, it begins at host time 0 and no frame is skipped.
// Single-threaded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::recording {

class PlaybackSchedule {
 public:
  /// `positions`: time of each frame after the start of the loop; at least one, increasing,
  /// spanning less than `loop_duration`. `opened`: now.
  PlaybackSchedule(std::vector<nanoseconds> positions, nanoseconds loop_duration, source::Pace pace,
                   bool loop, HostTime opened);

  struct Due {
    std::size_t frame;
    HostTime when;
  };
  /// Returns the frame after the previous one; nothing at the end. In real time, frames that a late
  /// caller missed are skipped: of the frames already due, the newest is returned.
  [[nodiscard]] std::optional<Due> next(HostTime now);

 private:
  [[nodiscard]] HostTime when(std::int64_t number) const;
  [[nodiscard]] std::int64_t first_not_before(HostTime time) const;

  std::vector<nanoseconds> positions_;
  nanoseconds loop_duration_;
  source::Pace pace_;
  bool loop_;
  HostTime origin_;                   // when position 0 of round 0 is due
  std::optional<std::int64_t> last_;  // frame numbers continue from round to round
};

}  // namespace roomcast::recording
