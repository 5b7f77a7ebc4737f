// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/rig_poses.h"

#include <algorithm>

#include "roomcast/io/file_bytes.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::cli {

Status write_rig_poses(const std::filesystem::path& rig, const alignment::AlignmentReport& report) {
  const bool any = std::any_of(report.sensors.begin(), report.sensors.end(),
                               [](const alignment::SensorReport& sensor) { return sensor.placed; });
  if (!any) {
    return Error{ErrorCode::kUnavailable,
                 "no sensor could be placed; the poses in rig.json are unchanged"};
  }
  auto description = recording::read_rig_json(rig / "rig.json");
  if (!description) return description.error();
  for (recording::RigSensorEntry& entry : description->sensors) {
    const auto found =
        std::find_if(report.sensors.begin(), report.sensors.end(),
                     [&](const alignment::SensorReport& sensor) { return sensor.id == entry.id; });
    if (found != report.sensors.end()) entry.world_from_depth = found->world_from_depth;
  }
  return io::write_file(rig / "rig.json", recording::rig_json_text(*description));
}

}  // namespace roomcast::cli
