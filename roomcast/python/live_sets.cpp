// SPDX-License-Identifier: Apache-2.0
#include "roomcast/python/live_sets.h"

#include <algorithm>
#include <utility>

namespace roomcast::python {
namespace {

bool same_sensors(const std::vector<recording::SetSensor>& a,
                  const std::vector<recording::SetSensor>& b) {
  return std::ranges::equal(a, b, [](const auto& one, const auto& other) {
    return one.name == other.name && one.depth == other.depth && one.fps == other.fps &&
           one.expected_error_m == other.expected_error_m && one.scale_error == other.scale_error;
  });
}

}  // namespace

std::shared_ptr<RoomSet> LiveRoomSets::set_of(const client::RoomSnapshot& room) {
  recording::LiveSet live = sets_.set_of(room);
  if (!sensors_ || !same_sensors(sensors_->list, live.sensors))
    sensors_ = std::make_shared<const RoomSensors>(std::move(live.sensors));
  auto set = std::make_shared<RoomSet>();
  set->sensors = sensors_;
  set->dated = true;
  set->set = std::move(live.set);
  set->sensors_sending = live.sensors_sending;
  set->may_export = client::check_may_export(room.rights);
  return set;
}

}  // namespace roomcast::python
