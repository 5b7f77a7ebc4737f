// SPDX-License-Identifier: Apache-2.0
// Two simulated sensors that are placed by moving people or boards and then, where possible,
// refined on the surfaces that both see, with the resulting errors. Shared by the suites of people
// and boards. Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/live_align/filmed_sensor.h"
#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/prior/refined_placement.h"

namespace roomcast::bench {

struct PairCase {
  std::string scene;
  std::uint64_t seed = 0;
  double apart_deg = 0;  // between the sensors' views
  bool placed = false;
  std::string reason;   // why it was not placed
  double error_mm = 0;  // at the middle of the room, 1 m high
  double turn_error_deg = 0;
  double found_error_mm = 0;  // before pose refinement
  double expected_error_mm = 0;
  double detector_ms = 0;  // CPU time per picture
};

using SensorPair = std::pair<FilmedSensor, FilmedSensor>;

/// Of `count` sensors around the room, the two whose viewing directions are closest to `apart_deg`
/// apart.
[[nodiscard]] Result<SensorPair> sensors_apart(
    const std::shared_ptr<const simulator::SimulatedRoom>& room, std::uint64_t seed,
    double apart_deg, int count = 4);

[[nodiscard]] PairCase case_of(const std::string& scene, std::uint64_t seed,
                               const SensorPair& sensors);

/// A sensor's view of the static room.
struct StillView {
  alignment::CalibrationBundle bundle;
  alignment::SensorView view;
};
using StillViews = std::pair<StillView, StillView>;

[[nodiscard]] Result<StillViews> still_views(SensorPair& sensors);

/// Fills `result` for a placed second sensor; the poses are of the depth cameras.
void place(const SensorPair& sensors, const alignment::EstimatedPlacement& a_from_b,
           PairCase& result);
/// As place(), with pose refinement where it is possible.
void place_refined(const SensorPair& sensors, const StillViews& views,
                   const alignment::EstimatedPlacement& a_from_b, PairCase& result);

/// Runs one case for each of `rooms` rooms with increasing seeds, in scenes with walking people.
/// Rooms without a walking person (kInvalidArgument) are skipped.
[[nodiscard]] Result<std::vector<PairCase>> run_rooms(
    int rooms, std::uint64_t first_seed,
    const std::function<Result<PairCase>(const char* scene, std::uint64_t seed)>& run_case,
    const std::function<void(std::string_view)>& progress);

void print_table(const std::vector<PairCase>& cases, std::ostream& out);
void print_json(const std::vector<PairCase>& cases, std::ostream& out);

}  // namespace roomcast::bench
