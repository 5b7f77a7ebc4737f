// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/playback/playback_schedule.h"

#include <algorithm>
#include <utility>

#include "roomcast/core/assert.h"

namespace roomcast::recording {
namespace {

std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}

}  // namespace

PlaybackSchedule::PlaybackSchedule(std::vector<nanoseconds> positions, nanoseconds loop_duration,
                                   source::Pace pace, bool loop, HostTime opened)
    : positions_(std::move(positions)), loop_duration_(loop_duration), pace_(pace), loop_(loop) {
  ROOMCAST_ASSERT(!positions_.empty());
  ROOMCAST_ASSERT(positions_.back() - positions_.front() < loop_duration_);
  if (pace_ == source::Pace::kRealTime && !loop_) origin_ = opened - positions_.front();
}

HostTime PlaybackSchedule::when(std::int64_t number) const {
  const auto count = static_cast<std::int64_t>(positions_.size());
  const std::int64_t round = floor_divide(number, count);
  const auto frame = static_cast<std::size_t>(number - round * count);
  return origin_ + round * loop_duration_ + positions_[frame];
}

std::int64_t PlaybackSchedule::first_not_before(HostTime time) const {
  const nanoseconds since_first = time - origin_ - positions_.front();
  const std::int64_t round = floor_divide(since_first.count(), loop_duration_.count());
  const nanoseconds position = time - origin_ - round * loop_duration_;
  const auto frame = std::lower_bound(positions_.begin(), positions_.end(), position);
  return round * static_cast<std::int64_t>(positions_.size()) + (frame - positions_.begin());
}

std::optional<PlaybackSchedule::Due> PlaybackSchedule::next(HostTime now) {
  const auto count = static_cast<std::int64_t>(positions_.size());
  std::int64_t number = last_ ? *last_ + 1 : 0;
  if (pace_ == source::Pace::kRealTime) {
    const std::int64_t newest_due = first_not_before(now + nanoseconds(1)) - 1;
    if (!last_ && loop_) number = first_not_before(now);
    if (last_) number = std::max(number, loop_ ? newest_due : std::min(newest_due, count - 1));
  }
  if (!loop_ && number >= count) return std::nullopt;
  last_ = number;
  const std::int64_t frame = number - floor_divide(number, count) * count;
  return Due{static_cast<std::size_t>(frame), when(number)};
}

}  // namespace roomcast::recording
