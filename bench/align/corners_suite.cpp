// SPDX-License-Identifier: Apache-2.0
#include "bench/align/corners_suite.h"

#include <algorithm>
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/alignment/rig/rig_aligner.h"

namespace roomcast::bench {
namespace {

constexpr const char* kScene = "corners";
constexpr int kSensors = 4;
const Eigen::Vector3d kMiddle_m(0, 1, 0);  // of the room

CornersRoom judged(std::uint64_t seed, const std::vector<SimulatedView>& views) {
  alignment::RigAligner aligner;
  std::vector<RigidTransform> seen_from;
  for (const SimulatedView& seen : views) {
    if (!seen.view) continue;
    aligner.add(seen.view);
    seen_from.push_back(seen.world_from_depth);
  }
  const alignment::AlignmentReport report = aligner.solve();
  CornersRoom room;
  room.seed = seed;
  room.sensors = views.size();
  std::vector<RigidTransform> truth, found;
  for (std::size_t i = 0; i < report.sensors.size(); ++i) {
    const alignment::SensorReport& sensor = report.sensors[i];
    if (!sensor.world_from_depth) continue;
    truth.push_back(seen_from[i]);
    found.push_back(*sensor.world_from_depth);
    room.expected_mm = std::max(room.expected_mm, sensor.expected_error_mm);
    room.expected_deg = std::max(room.expected_deg, sensor.expected_error_deg);
  }
  room.placed = found.size();
  if (!found.empty()) room.error = rig_error(truth, found, kMiddle_m);
  return room;
}

}  // namespace

Result<std::vector<CornersRoom>> run_corners_suite(const CornersSuiteOptions& options,
                                                   const BenchProgress& progress) {
  std::vector<CornersRoom> rooms;
  for (int i = 0; i < options.rooms; ++i) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(i);
    if (progress) progress(fmt::format("room {} of {}: seed {}", i + 1, options.rooms, seed));
    const auto views = simulate_views({kScene, seed, kSensors, options.frames, options.sensing});
    if (!views) return views.error();
    rooms.push_back(judged(seed, *views));
  }
  return rooms;
}

void print_table(const std::vector<CornersRoom>& rooms, std::ostream& out) {
  out << "Worst sensor, at the middle of the room.\n"
      << fmt::format("{:>6} {:>8} {:>22} {:>22} {:>22}\n", "seed", "placed", "from the mean of all",
                     "from the first sensor", "expected, 2.5 m ahead");
  for (const CornersRoom& room : rooms) {
    out << fmt::format(
        "{:>6} {:>3} of {:<1} {:>10.1f} mm {:>4.2f} deg {:>10.1f} mm {:>4.2f} deg "
        "{:>10.1f} mm {:>4.2f} deg\n",
        room.seed, room.placed, room.sensors, room.error.from_all_mm, room.error.from_all_deg,
        room.error.from_first_mm, room.error.from_first_deg, room.expected_mm, room.expected_deg);
  }
}

void print_json(const std::vector<CornersRoom>& rooms, std::ostream& out) {
  nlohmann::json json = {{"rooms", nlohmann::json::array()}};
  for (const CornersRoom& room : rooms) {
    json["rooms"].push_back({{"seed", room.seed},
                             {"sensors", room.sensors},
                             {"placed", room.placed},
                             {"from_all_mm", room.error.from_all_mm},
                             {"from_all_deg", room.error.from_all_deg},
                             {"from_first_mm", room.error.from_first_mm},
                             {"from_first_deg", room.error.from_first_deg},
                             {"expected_mm", room.expected_mm},
                             {"expected_deg", room.expected_deg}});
  }
  out << json.dump(1) << "\n";
}

}  // namespace roomcast::bench
