// SPDX-License-Identifier: Apache-2.0
#include "bench/real/rig_judge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <system_error>

#include <Eigen/Geometry>

#include "roomcast/io/json_fields.h"

namespace roomcast::bench {
namespace {

using alignment::AlignmentReport;
using alignment::PairReport;
using alignment::SensorReport;

constexpr double kAhead_m = 2.5;

/// A sensor's places of the ball by frame, metres, its own frame.
using BallPlaces = std::map<std::string, std::map<std::uint64_t, Eigen::Vector3d>>;

Result<BallPlaces> read_ball(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return BallPlaces{};
  const auto json = io::read_json_object(file);
  if (!json) return json.error();
  io::JsonProblems problems(file);
  const io::JsonFields fields(*json, "", problems);
  BallPlaces places;
  for (const io::JsonFields& entry : fields.objects("ball")) {
    const std::vector<double> centre = entry.numbers("center_in_depth_camera_mm");
    const int frame = entry.integer("frame");
    if (centre.size() != 3) entry.reject("center_in_depth_camera_mm", "must be three numbers");
    if (frame < 0) entry.reject("frame", "must not be negative");
    if (!problems.status()) break;
    places[entry.text("sensor")][static_cast<std::uint64_t>(frame)] =
        0.001 * Eigen::Vector3d(centre[0], centre[1], centre[2]);
  }
  if (auto status = problems.status(); !status) return status.error();
  return places;
}

double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

Eigen::Vector3d in_world(const SensorReport& sensor, const Eigen::Vector3d& point_m) {
  return *sensor.world_from_depth * Eigen::Vector3d(sensor.depth_scale * point_m);
}

std::vector<BallGap> ball_gaps(const BallPlaces& places, const std::vector<SensorReport>& placed) {
  std::vector<BallGap> gaps;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (std::size_t j = i + 1; j < placed.size(); ++j) {
      const SensorReport &a = placed[i], &b = placed[j];
      if (!places.contains(a.id) || !places.contains(b.id)) continue;
      std::vector<double> distances_mm;
      for (const auto& [frame, point_m] : places.at(a.id)) {
        const auto other = places.at(b.id).find(frame);
        if (other == places.at(b.id).end()) continue;
        distances_mm.push_back(1000 * (in_world(a, point_m) - in_world(b, other->second)).norm());
      }
      if (distances_mm.empty()) continue;
      gaps.push_back({a.id, b.id, distances_mm.size(), median_of(distances_mm),
                      std::hypot(a.expected_error_mm, b.expected_error_mm)});
    }
  }
  return gaps;
}

/// Displacement of a point 2.5 m ahead, and the angle, of what should be the identity.
std::pair<double, double> error_of(const RigidTransform& error) {
  const Eigen::Vector3d ahead(0, 0, kAhead_m);
  const double angle = Eigen::AngleAxisd(error.rotation).angle();
  return {1000 * (error * ahead - ahead).norm(), angle * 180 / std::numbers::pi};
}

std::optional<RigidTransform> known_pose(const recording::RigDescription& rig,
                                         const std::string& id) {
  const auto found = std::ranges::find(rig.sensors, id, &recording::RigSensorEntry::id);
  return found == rig.sensors.end() ? std::nullopt : found->world_from_depth;
}

std::vector<PoseGap> known_gaps(const recording::RigDescription& rig,
                                const std::vector<SensorReport>& placed) {
  std::vector<PoseGap> gaps;
  const auto first = placed.empty() ? std::nullopt : known_pose(rig, placed.front().id);
  for (std::size_t i = 1; first && i < placed.size(); ++i) {
    const auto known = known_pose(rig, placed[i].id);
    if (!known) continue;
    const RigidTransform found =
        placed.front().world_from_depth->inverse() * *placed[i].world_from_depth;
    const auto [mm, deg] = error_of((first->inverse() * *known).inverse() * found);
    gaps.push_back({placed[i].id, mm, deg});
  }
  return gaps;
}

std::optional<RigidTransform> relative(const AlignmentReport& report, const std::string& to,
                                       const std::string& from) {
  for (const PairReport& pair : report.pairs) {
    if (!pair.accepted || !pair.b_from_a) continue;
    if (pair.a == from && pair.b == to) return pair.b_from_a;
    if (pair.a == to && pair.b == from) return pair.b_from_a->inverse();
  }
  return std::nullopt;
}

std::vector<Loop> loops_of(const AlignmentReport& report) {
  std::vector<Loop> loops;
  const auto& all = report.sensors;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const auto b_from_a = relative(report, all[j].id, all[i].id);
      for (std::size_t k = j + 1; b_from_a && k < all.size(); ++k) {
        const auto c_from_b = relative(report, all[k].id, all[j].id);
        const auto a_from_c = relative(report, all[i].id, all[k].id);
        if (!c_from_b || !a_from_c) continue;
        const auto [mm, deg] = error_of(*a_from_c * *c_from_b * *b_from_a);
        loops.push_back({all[i].id, all[j].id, all[k].id, mm, deg});
      }
    }
  }
  return loops;
}

}  // namespace

Result<RigJudgement> judge_rig(const std::filesystem::path& folder,
                               const recording::RigDescription& rig,
                               const AlignmentReport& alignment) {
  const auto ball = read_ball(folder / "ball.json");
  if (!ball) return ball.error();
  std::vector<SensorReport> placed;
  std::ranges::copy_if(alignment.sensors, std::back_inserter(placed),
                       [](const SensorReport& sensor) {
                         return sensor.placed && sensor.world_from_depth.has_value();
                       });
  return RigJudgement{ball_gaps(*ball, placed), known_gaps(rig, placed), loops_of(alignment)};
}

}  // namespace roomcast::bench
