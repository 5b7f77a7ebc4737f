// SPDX-License-Identifier: Apache-2.0
#include "roomcast/python/room_sets.h"

#include <algorithm>
#include <utility>

namespace roomcast::python {
namespace {

std::vector<std::unique_ptr<CloudMaker>> single_makers(
    const std::vector<recording::SetSensor>& sensors) {
  std::vector<std::unique_ptr<CloudMaker>> makers;
  for (const recording::SetSensor& sensor : sensors)
    makers.push_back(std::make_unique<CloudMaker>(std::vector{sensor}));
  return makers;
}

}  // namespace

RoomSensors::RoomSensors(std::vector<recording::SetSensor> all)
    : list(std::move(all)),
      clouds(std::make_unique<CloudMaker>(list)),
      cloud_of(single_makers(list)) {}

const recording::SetFrame* RoomSet::frame_of(const std::string& sensor) const {
  const auto found = std::ranges::find_if(set.frames, [&](const recording::SetFrame& frame) {
    return sensors->list[frame.sensor].name == sensor;
  });
  return found == set.frames.end() ? nullptr : &*found;
}

Result<std::shared_ptr<const recording::PointCloud>> cloud_of(
    const RoomSet& set, const recording::MergedCloudOptions& options) {
  return set.sensors->clouds->make(set.set, options);
}

Result<std::shared_ptr<const recording::PointCloud>> cloud_of(
    const RoomSet& set, std::size_t frame, const recording::MergedCloudOptions& options) {
  recording::FrameSet alone = {.number = set.set.number, .time = set.set.time, .frames = {}};
  alone.frames.push_back(set.set.frames[frame]);
  alone.frames[0].sensor = 0;
  return set.sensors->cloud_of[set.set.frames[frame].sensor]->make(alone, options);
}

}  // namespace roomcast::python
