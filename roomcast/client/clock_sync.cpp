// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/clock_sync.h"

#include <algorithm>

namespace roomcast {

void ClockSync::add(HostTime sent, RoomTime hub, HostTime received) {
  if (received < sent) return;
  const nanoseconds round_trip = received - sent;
  const nanoseconds host_middle = sent.time_since_epoch() + round_trip / 2;
  exchanges_[count_++ % kWindow] = {round_trip, hub.time_since_epoch() - host_middle};
}

std::optional<ClockEstimate> ClockSync::estimate() const {
  if (count_ == 0) return std::nullopt;
  const auto end = exchanges_.begin() + static_cast<std::ptrdiff_t>(std::min(count_, kWindow));
  const auto quickest = std::min_element(
      exchanges_.begin(), end,
      [](const Exchange& a, const Exchange& b) { return a.round_trip < b.round_trip; });
  return ClockEstimate{quickest->room_minus_host, (quickest->round_trip + nanoseconds(1)) / 2};
}

}  // namespace roomcast
