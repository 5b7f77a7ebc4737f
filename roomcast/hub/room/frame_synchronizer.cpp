// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/frame_synchronizer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "roomcast/core/assert.h"
#include "roomcast/hub/room/framed_control.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

nanoseconds period_of(double fps) {
  return nanoseconds(fps > 0 ? static_cast<std::int64_t>(std::llround(1e9 / fps)) : 0);
}

net::FramedMessagePtr end_of(SetId set) {
  wire::pb::Control message;
  message.mutable_set_end()->set_set_id(set.value);
  return framed_control(message);
}

}  // namespace

void FrameSynchronizer::add_sensor(SensorId sensor, double fps, std::uint64_t other_hub) {
  sensors_[sensor] = {.fps = fps, .other_hub = other_hub, .last = {}};
  follow_rate();
}

void FrameSynchronizer::pause_sensor(SensorId sensor, bool is_paused) {
  const auto found = sensors_.find(sensor);
  if (found == sensors_.end() || found->second.is_paused == is_paused) return;
  found->second.is_paused = is_paused;
  found->second.last.reset();
  found->second.small.clear();
  found->second.gaps = {};
}

void FrameSynchronizer::remove_sensor(SensorId sensor) {
  const auto found = sensors_.find(sensor);
  if (found == sensors_.end()) return;
  const std::uint64_t hub = found->second.other_hub;
  sensors_.erase(found);
  const auto is_there = [hub](const auto& entry) { return entry.second.other_hub == hub; };
  if (std::ranges::none_of(sensors_, is_there)) other_hubs_.erase(hub);
  follow_rate();
}

double FrameSynchronizer::fps() const {
  double highest = 0;
  for (const auto& [id, sensor] : sensors_) highest = std::max(highest, sensor.fps);
  return highest;
}

// Another rate changes the slot numbers: closes all open sets and resets all sensors.
void FrameSynchronizer::follow_rate() {
  const nanoseconds period = period_of(fps());
  if (period == period_) return;
  while (!open_.empty()) close_oldest();
  newest_closed_.reset();
  for (auto& [id, sensor] : sensors_) sensor.last.reset();
  other_hubs_.clear();
  period_ = period;
}

FrameSynchronizer::Slot FrameSynchronizer::natural_slot(RoomTime capture) const {
  const double periods = static_cast<double>(capture.time_since_epoch().count()) /
                         static_cast<double>(period_.count());
  return static_cast<Slot>(std::floor(periods + 0.5));
}

/// The time between two frames of a sensor: by its rate, or longer if its last frames were. A
/// sensor sends fewer frames on a line that carries no more, or while layer 0 suffices.
nanoseconds FrameSynchronizer::interval_of(const Sensor& sensor) {
  return std::max(period_of(sensor.fps), std::min(sensor.gaps[0], sensor.gaps[1]));
}

// A frame too late for its own set goes into the next open one. If the phase of a sensor falls on
// the border between two slots, two frames can fall into one slot; the second then goes into the
// next. A sensor that catches up, for example after a network stall, may have several frames in a
// set, because dropping one would cost a key frame.
std::optional<FrameSynchronizer::Slot> FrameSynchronizer::assign_slot(const Sensor& sensor,
                                                                      RoomTime capture) const {
  const Slot natural = natural_slot(capture);
  const Slot slot = newest_closed_ ? std::max(natural, *newest_closed_ + 1) : natural;
  if (!sensor.last || sensor.last->slot < slot) return slot;
  const bool on_border =
      sensor.last->slot == natural && natural_slot(sensor.last->capture_time) == natural;
  if (on_border) return natural + 1;
  if (sensor.last->frames_in_slot >= kMaxFramesOfSensorInSet) return std::nullopt;
  return sensor.last->slot;
}

bool FrameSynchronizer::add_frame(const wire::FrameHeader& header, net::MessageBuffer message,
                                  RoomTime now) {
  const auto found = sensors_.find(header.sensor);
  ROOMCAST_ASSERT(found != sensors_.end());
  Sensor& sensor = found->second;
  if (header.small) {
    if (sensor.small.size() >= kMaxFramesOfSensorInSet) return false;
    sensor.small.push_back({header, std::move(message)});
    return true;
  }
  const auto slot = assign_slot(sensor, header.capture_time);
  if (!slot) return false;
  const bool is_late = newest_closed_ && natural_slot(header.capture_time) <= *newest_closed_;
  const bool joins_own = sensor.last && sensor.last->slot == *slot;
  const std::size_t frames_in_slot = joins_own ? sensor.last->frames_in_slot + 1 : 1;
  if (sensor.last) sensor.gaps = {header.capture_time - sensor.last->capture_time, sensor.gaps[0]};
  sensor.last = Sensor::Delivery{*slot, is_late, frames_in_slot, header.capture_time, now};
  if (sensor.other_hub != 0) note_closing(sensor.other_hub, *slot, header.last);
  const auto [set, is_new] = open_.try_emplace(*slot);
  if (is_new) {
    set->second.deadline = now + std::max<nanoseconds>(wire::kSetDeadline, period_);
    set->second.frames.reserve(sensors_.size());
  }
  std::ranges::move(sensor.small, std::back_inserter(set->second.frames));
  sensor.small.clear();
  set->second.frames.push_back({header, std::move(message)});
  if (open_.size() > kMaxOpenSets) close_oldest();
  return true;
}

void FrameSynchronizer::note_closing(std::uint64_t other_hub, Slot slot, bool is_last) {
  const auto [found, is_new] = other_hubs_.try_emplace(other_hub, OtherHub{slot, slot - 1});
  OtherHub& hub = found->second;
  hub.newest = std::max(hub.newest, slot);
  if (is_last) hub.closed = hub.newest;
}

// Returns whether the sensor's frame for this slot is still expected by the sensor's own rate, and
// would be in time with the delay of its last frame. A late frame placed in this slot does not
// count as the slot's frame: if the sensor were not awaited now, it would stay one slot behind
// forever. A slot that is still in the future was opened by a sensor that exceeds its rate; the
// other sensors are awaited as usual.
bool FrameSynchronizer::is_due(const Sensor& sensor, Slot slot, RoomTime deadline,
                               RoomTime now) const {
  if (sensor.is_paused || !sensor.last) return false;
  if (now - sensor.last->arrival_time > wire::kSensorSilent) return false;
  const auto hub = other_hubs_.find(sensor.other_hub);
  if (hub != other_hubs_.end() && slot <= hub->second.closed) return false;
  const auto& last = *sensor.last;
  const bool has_delivered = last.slot > slot || (last.slot == slot && !last.is_late);
  if (has_delivered || natural_slot(last.capture_time + interval_of(sensor)) > slot) return false;
  if (slot > natural_slot(now)) return true;
  const nanoseconds on_the_way = last.arrival_time - last.capture_time;
  return RoomTime(slot * period_) + on_the_way <= deadline;
}

bool FrameSynchronizer::is_complete(Slot slot, RoomTime deadline, RoomTime now) const {
  return std::none_of(sensors_.begin(), sensors_.end(),
                      [&](const auto& entry) { return is_due(entry.second, slot, deadline, now); });
}

void FrameSynchronizer::close_oldest() {
  auto node = open_.extract(open_.begin());
  auto set = std::make_shared<FrameSet>();
  set->id = SetId{next_set_id_++};
  auto& frames = node.mapped().frames;
  set->frames.reserve(frames.size());
  for (Pending& pending : frames) {
    pending.header.set = set->id;
    pending.header.last = &pending == &frames.back();
    wire::stamp_frame_set(pending.message.payload(), set->id, pending.header.last);
    set->frames.push_back({pending.header, net::frame_message(std::move(pending.message))});
  }
  if (set->frames.size() > 1) set->end = end_of(set->id);
  newest_closed_ = node.key();
  closed_.push_back(std::move(set));
}

std::vector<FrameSetPtr> FrameSynchronizer::take_closed(RoomTime now) {
  while (!open_.empty()) {
    const auto& [slot, set] = *open_.begin();
    if (now < set.deadline && !is_complete(slot, set.deadline, now)) break;
    close_oldest();
  }
  return std::exchange(closed_, {});
}

std::optional<RoomTime> FrameSynchronizer::next_deadline() const {
  if (open_.empty()) return std::nullopt;
  return open_.begin()->second.deadline;
}

}  // namespace roomcast::hub
