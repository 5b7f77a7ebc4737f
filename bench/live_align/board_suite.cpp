// SPDX-License-Identifier: Apache-2.0
#include "bench/live_align/board_suite.h"

#include <cmath>
#include <utility>

#include "bench/codec/cpu_stopwatch.h"
#include "roomcast/alignment/board/board_match.h"
#include "roomcast/alignment/board/tag_tracker.h"

namespace roomcast::bench {
namespace {

/// A tag is detected up to about 60 degrees off its normal. Two sensors much further apart can
/// hardly ever detect the same flat board.
constexpr double kApart_deg = 60;
constexpr int kSensorsAroundBoard = 6;
constexpr nanoseconds kSecondSensorsDelay =
    std::chrono::milliseconds(23);  // sensors are not synchronised

std::vector<alignment::TagSighting> watch_board(FilmedSensor& sensor,
                                                const BoardSuiteOptions& options, nanoseconds phase,
                                                double& detector_ms) {
  alignment::TagTracker tags(sensor.calibration());
  std::vector<alignment::TagSighting> sightings;
  const int frames = static_cast<int>(options.seconds * options.fps);
  for (int i = 0; i < frames; ++i) {
    const auto time = phase + nanoseconds(std::llround(1e9 * static_cast<double>(i) / options.fps));
    const DepthImage& depth_mm = sensor.depth_mm(time);
    const ColorImage& color = sensor.color();
    const CpuStopwatch watch;
    const auto found = tags.find(depth_mm.view(), color.view());
    detector_ms += watch.ms() / frames;
    for (const auto& tag : found)
      sightings.push_back({1e-9 * static_cast<double>(time.count()), tag.id, tag.corners_m});
  }
  return sightings;
}

Result<PairCase> run_case(const char* scene, std::uint64_t seed, const BoardSuiteOptions& options) {
  const auto room = simulator::SimulatedRoom::build(scene, seed, simulator::Visitor::kBoardBearer);
  if (!room) return room.error();
  auto sensors = sensors_apart(*room, seed, kApart_deg, kSensorsAroundBoard);
  if (!sensors) return sensors.error();
  PairCase result = case_of(scene, seed, *sensors);
  double a_ms = 0, b_ms = 0;
  const auto seen_by_a = watch_board(sensors->first, options, {}, a_ms);
  const auto seen_by_b = watch_board(sensors->second, options, kSecondSensorsDelay, b_ms);
  result.detector_ms = (a_ms + b_ms) / 2;
  const auto match = alignment::match_boards(seen_by_a, seen_by_b);
  if (match) {
    place(*sensors, {match->a_from_b, match->expected_error_mm}, result);
  } else {
    result.reason = match.error().message;
  }
  return result;
}

}  // namespace

Result<std::vector<PairCase>> run_board_suite(
    const BoardSuiteOptions& options, const std::function<void(std::string_view)>& progress) {
  const auto run = [&options](const char* scene, std::uint64_t seed) {
    return run_case(scene, seed, options);
  };
  return run_rooms(options.rooms, options.seed, run, progress);
}

}  // namespace roomcast::bench
