// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/device_clock.h"

#include <algorithm>
#include <cmath>

#include "roomcast/core/assert.h"

namespace roomcast::source {

HostTime DeviceClock::capture_time(nanoseconds device_time, HostTime arrived) {
  const nanoseconds delay = arrived.time_since_epoch() - device_time;
  const bool leapt = smallest_ && std::chrono::abs(delay - *smallest_) > kLeap;
  if (leapt) smallest_.reset();
  if (!smallest_) {
    begin_window(arrived, delay);
    before_.reset();
  } else if (arrived - window_began_ > kWindow) {
    before_ = smallest_;
    begin_window(arrived, delay);
  }
  smallest_ = std::min(*smallest_, delay);
  const nanoseconds offset = before_ ? std::min(*before_, *smallest_) : *smallest_;
  return std::min(HostTime(device_time + offset), arrived);
}

void DeviceClock::begin_window(HostTime arrived, nanoseconds delay) {
  window_began_ = arrived;
  smallest_ = delay;
}

TickCounter::TickCounter(int bits, double ticks_per_second)
    : mask_(bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1),
      nanoseconds_per_tick_(1e9 / ticks_per_second) {
  ROOMCAST_ASSERT(bits > 0 && ticks_per_second > 0);
}

nanoseconds TickCounter::time(std::uint64_t ticks) {
  if (last_) {
    // Two streams share a counter and may arrive slightly out of order: a small step back must not
    // count as almost a whole wrap.
    const std::uint64_t forward = (ticks - *last_) & mask_;
    const std::uint64_t back = (*last_ - ticks) & mask_;
    total_ = forward <= back ? total_ + forward : total_ - std::min(back, total_);
  } else {
    total_ = ticks & mask_;
  }
  last_ = ticks;
  return nanoseconds(std::llround(static_cast<double>(total_) * nanoseconds_per_tick_));
}

}  // namespace roomcast::source
