// SPDX-License-Identifier: Apache-2.0
#include "bench/live_align/person_suite.h"

#include <cmath>
#include <utility>

#include "bench/codec/cpu_stopwatch.h"
#include "roomcast/alignment/person/head_detector.h"
#include "roomcast/alignment/person/trajectory_match.h"

namespace roomcast::bench {
namespace {

constexpr nanoseconds kWalkBegins = std::chrono::seconds(6);
constexpr nanoseconds kPhaseOfSecond =
    std::chrono::milliseconds(23);  // sensors are not synchronised

struct Walk {
  RigidTransform level_from_depth;
  std::vector<alignment::HeadSighting> sightings;
  double detector_ms = 0;
};

Result<Walk> observe_walk(FilmedSensor& sensor, const StillView& still,
                          const PersonSuiteOptions& options, nanoseconds phase) {
  const auto& floor = still.view.floor;
  if (!floor) return Error{ErrorCode::kUnavailable, "no floor is seen"};
  alignment::HeadDetector heads(still.bundle, *floor);
  Walk walk{alignment::level_from_depth(*floor), {}, 0};
  const int frames = static_cast<int>(options.seconds * options.fps);
  for (int i = 0; i < frames; ++i) {
    const auto time =
        kWalkBegins + phase + nanoseconds(std::llround(1e9 * static_cast<double>(i) / options.fps));
    const DepthImage& depth_mm = sensor.depth_mm(time);
    const CpuStopwatch watch;
    const auto found = heads.find(depth_mm.view());
    walk.detector_ms += watch.ms() / frames;
    for (const auto& head : found) {
      walk.sightings.push_back(alignment::head_sighting(
          walk.level_from_depth, 1e-9 * double(time.count()), head.cast<double>()));
    }
  }
  return walk;
}

Result<PairCase> run_case(const char* scene, std::uint64_t seed,
                          const PersonSuiteOptions& options) {
  const auto room = simulator::SimulatedRoom::build(
      scene, seed, options.unaware ? simulator::Visitor::kNone : simulator::Visitor::kWalkabout);
  if (!room) return room.error();
  auto sensors = sensors_apart(*room, seed, 180);
  if (!sensors) return sensors.error();
  PairCase result = case_of(scene, seed, *sensors);
  const auto still = still_views(*sensors);
  if (!still) {
    result.reason = still.error().message;
    return result;
  }
  const auto seen_by_a = observe_walk(sensors->first, still->first, options, {});
  const auto seen_by_b = observe_walk(sensors->second, still->second, options, kPhaseOfSecond);
  if (!seen_by_a || !seen_by_b) {
    result.reason = (seen_by_a ? seen_by_b : seen_by_a).error().message;
    return result;
  }
  result.detector_ms = (seen_by_a->detector_ms + seen_by_b->detector_ms) / 2;
  const auto match = alignment::match_walks(seen_by_a->sightings, seen_by_b->sightings);
  if (match) {
    const RigidTransform a_from_b =
        seen_by_a->level_from_depth.inverse() * match->a_from_b * seen_by_b->level_from_depth;
    place_refined(*sensors, *still, {a_from_b, match->expected_error_mm}, result);
  } else {
    result.reason = match.error().message;
  }
  return result;
}

}  // namespace

Result<std::vector<PairCase>> run_person_suite(
    const PersonSuiteOptions& options, const std::function<void(std::string_view)>& progress) {
  const auto run = [&options](const char* scene, std::uint64_t seed) {
    return run_case(scene, seed, options);
  };
  return run_rooms(options.rooms, options.seed, run, progress);
}

}  // namespace roomcast::bench
