// SPDX-License-Identifier: Apache-2.0
#include "bench/render/aligned_poses.h"

#include <map>
#include <string>

#include "roomcast/io/json_fields.h"

namespace roomcast::bench {

Result<std::vector<RigidTransform>> read_aligned_poses(const std::filesystem::path& report,
                                                       const recording::RigDescription& rig) {
  const auto json = io::read_json_object(report);
  if (!json) return json.error();
  io::JsonProblems problems(report);
  const io::JsonFields fields(*json, "", problems);
  std::map<std::string, RigidTransform> aligned_from_depth;
  for (const io::JsonFields& sensor : fields.objects("sensors")) {
    if (!sensor.boolean("placed", false)) continue;
    aligned_from_depth.emplace(sensor.text("id"), sensor.transform("world_from_depth"));
  }
  if (auto status = problems.status(); !status) return status.error();

  std::vector<RigidTransform> poses;
  for (const recording::RigSensorEntry& sensor : rig.sensors) {
    const auto found = aligned_from_depth.find(sensor.id);
    if (found == aligned_from_depth.end()) {
      return Error{ErrorCode::kInvalidArgument, report.string() + " does not place " + sensor.id};
    }
    poses.push_back(found->second);
  }
  if (poses.empty() || !rig.sensors.front().world_from_depth) return poses;
  const RigidTransform world_from_aligned =
      *rig.sensors.front().world_from_depth * poses.front().inverse();
  for (RigidTransform& pose : poses) pose = world_from_aligned * pose;
  return poses;
}

}  // namespace roomcast::bench
