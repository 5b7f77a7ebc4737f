// SPDX-License-Identifier: Apache-2.0
// Two simulated sensors that are placed by what passes through their views, and perhaps settle on
// what both see of the room, and how well that went: what the suites of walkers and boards have in
// common. Single-threaded.
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
  std::string reason;   // why not
  double error_mm = 0;  // at the middle of the room, 1 m high
  double turn_error_deg = 0;
  double found_error_mm = 0;  // before it settled on what both sensors see
  double expected_error_mm = 0;
  double look_ms = 0;  // CPU of looking at one picture
};

using SensorPair = std::pair<FilmedSensor, FilmedSensor>;

/// Of so many sensors around the room the two whose views are most nearly so far apart.
[[nodiscard]] Result<SensorPair> sensors_apart(const std::shared_ptr<const simulator::SimulatedRoom>& room,
                                               std::uint64_t seed, double apart_deg, int count = 4);

[[nodiscard]] PairCase case_of(const std::string& scene, std::uint64_t seed,
                               const SensorPair& sensors);

/// What a sensor sees of the room itself.
struct StillView {
  alignment::CalibrationBundle bundle;
  alignment::SensorView view;
};
using StillViews = std::pair<StillView, StillView>;

[[nodiscard]] Result<StillViews> still_views(SensorPair& sensors);

/// The second sensor was placed; the poses are of their depth frames.
void place(const SensorPair& sensors, const alignment::EstimatedPlacement& a_from_b, PairCase& result);
/// ... and settles where it can.
void place_settled(const SensorPair& sensors, const StillViews& views,
                   const alignment::EstimatedPlacement& a_from_b, PairCase& result);

/// A case for each of so many rooms, the first of this seed and each of the next, in scenes where
/// somebody walks; rooms in which nobody does (kInvalidArgument) are passed over.
[[nodiscard]] Result<std::vector<PairCase>> run_rooms(
    int rooms, std::uint64_t first_seed,
    const std::function<Result<PairCase>(const char* scene, std::uint64_t seed)>& run_case,
    const std::function<void(std::string_view)>& progress);

void print_table(const std::vector<PairCase>& cases, std::ostream& out);
void print_json(const std::vector<PairCase>& cases, std::ostream& out);

}  // namespace roomcast::bench
