// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/rig_poses.h"

#include <algorithm>

#include <fmt/format.h>

#include "roomcast/io/file_bytes.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::cli {
namespace {

Status check_depth_scale(const recording::RigSensorEntry& entry) {
  if (recording::is_depth_scale(entry.depth_scale)) return {};
  return Error{ErrorCode::kInvalidArgument,
               fmt::format("the depth scale of {} would become {:.3f}; rig.json is unchanged. "
                           "Check depth_scale_to_metre in its camera.json",
                           entry.id, entry.depth_scale)};
}

}  // namespace

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
    if (found == report.sensors.end()) continue;
    entry.world_from_depth = found->world_from_depth;
    entry.expected_error_mm = found->expected_error_mm;
    // The sensor was aligned with the depth scale that it had, so the two are multiplied.
    if (found->placed) entry.depth_scale *= found->depth_scale;
    if (Status status = check_depth_scale(entry); !status) return status;
  }
  description->scale_error = report.scale_error;
  return io::write_file(rig / "rig.json", recording::rig_json_text(*description));
}

}  // namespace roomcast::cli
