// SPDX-License-Identifier: Apache-2.0
#include "bench/live_align/moved_suite.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <ostream>
#include <random>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/codec/cpu_stopwatch.h"
#include "bench/live_align/filmed_sensor.h"
#include "roomcast/alignment/motion/pose_change_detector.h"

namespace roomcast::bench {
namespace {

constexpr int kSensorsOfRoom = 3;
constexpr int kFramesOfBundle = 7;
constexpr nanoseconds kWatchFrom = std::chrono::seconds(6);
constexpr nanoseconds kGiveUp = std::chrono::seconds(6);

Eigen::Vector3d any_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

RigidTransform push_of(const Eigen::Vector3d& direction, double shift_m, double angle_rad) {
  RigidTransform push;
  push.translation_m = shift_m * direction;
  push.rotation = Eigen::AngleAxisd(angle_rad, direction).toRotationMatrix();
  return push;
}

/// One scene, checked by the pose change detector as on a sensor.
class Scene {
 public:
  Scene(std::shared_ptr<const simulator::SimulatedRoom> room, const MovedSuiteOptions& options)
      : room_(std::move(room)), options_(options), random_(static_cast<unsigned>(options.seed)) {}

  Status run(MovedRow& row) {
    auto still = open({});
    if (!still) return still.error();
    const auto bundle = still->bundle(kFramesOfBundle);
    if (!bundle) return bundle.error();
    watch_unmoved(*still, *bundle, row);
    for (int i = 0; i < options_.pushes; ++i) {
      const Eigen::Vector3d direction = any_direction(random_);
      constexpr double kDegree = std::numbers::pi / 180;
      for (const auto& [push, tally] :
           {std::pair(push_of(direction, 0.02, 0), &row.two_cm),
            std::pair(push_of(direction, 0, 0.5 * kDegree), &row.half_degree),
            std::pair(push_of(direction, 0.01, 0), &row.one_cm),
            std::pair(push_of(direction, 0, 0.2 * kDegree), &row.fifth_degree)}) {
        if (auto status = watch_push(*still, *bundle, push, *tally); !status) return status;
      }
    }
    return {};
  }

 private:
  Result<FilmedSensor> open(const RigidTransform& push) const {
    simulator::SimulatedSensor::Options sensing;
    sensing.index = static_cast<int>(options_.seed) % kSensorsOfRoom;
    sensing.count = kSensorsOfRoom;
    sensing.seed = options_.seed;
    sensing.sensing.half_color = true;
    sensing.mount_from_depth = push;
    return FilmedSensor::open(room_, sensing);
  }

  void watch_unmoved(FilmedSensor& sensor, const alignment::CalibrationBundle& bundle,
                     MovedRow& row) {
    alignment::PoseChangeDetector watch(bundle);
    double cpu = 0;
    const nanoseconds end(std::llround(60e9 * options_.minutes));
    for (nanoseconds time{}; time < end; time += alignment::kCheckInterval) {
      const DepthImage& depth_mm = sensor.depth_mm(kWatchFrom + time);
      const CpuStopwatch stopwatch;
      const bool alarm = watch.moved(depth_mm.view(), HostTime(time));
      cpu += stopwatch.ms();
      ++row.checks;
      if (!alarm) continue;
      ++row.alarms;
      watch = alignment::PoseChangeDetector(bundle);
    }
    row.detector_ms = cpu / std::max(1, row.checks);
  }

  /// Measures the detection time of a push between two checks.
  Status watch_push(FilmedSensor& still, const alignment::CalibrationBundle& bundle,
                    const RigidTransform& push, PushTally& tally) {
    auto pushed = open(push);
    if (!pushed) return pushed.error();
    alignment::PoseChangeDetector watch(bundle);
    const nanoseconds begin =
        kWatchFrom + std::chrono::milliseconds(std::uniform_int_distribution(0, 60'000)(random_));
    (void)watch.moved(still.depth_mm(begin).view(), HostTime(begin));
    ++tally.pushes;
    constexpr nanoseconds kFirstFrame = std::chrono::milliseconds(33);
    for (nanoseconds since = kFirstFrame; since < kGiveUp; since += alignment::kCheckInterval) {
      // Right after a check, when the time until the next one is longest.
      const nanoseconds time = begin + since + alignment::kCheckInterval - kFirstFrame;
      if (!watch.moved(pushed->depth_mm(time).view(), HostTime(time))) continue;
      ++tally.noticed;
      tally.longest_s =
          std::max(tally.longest_s, std::chrono::duration<double>(time - begin).count());
      break;
    }
    return {};
  }

  std::shared_ptr<const simulator::SimulatedRoom> room_;
  const MovedSuiteOptions& options_;
  std::mt19937 random_;
};

std::string text_of(const PushTally& tally) {
  return fmt::format("{:2}/{:<2} {:4.1f} s", tally.noticed, tally.pushes, tally.longest_s);
}

nlohmann::json json_of(const PushTally& tally) {
  return {{"pushes", tally.pushes}, {"noticed", tally.noticed}, {"longest_s", tally.longest_s}};
}

}  // namespace

Result<std::vector<MovedRow>> run_moved_suite(
    const MovedSuiteOptions& options, const std::function<void(std::string_view)>& progress) {
  std::vector<std::string> scenes = options.scenes;
  if (scenes.empty()) scenes.assign(simulator::kSceneNames.begin(), simulator::kSceneNames.end());
  std::vector<MovedRow> rows;
  for (const std::string& scene : scenes) {
    progress(fmt::format("scene {} of {}: {}", rows.size() + 1, scenes.size(), scene));
    auto room = simulator::SimulatedRoom::build(scene, options.seed);
    if (!room) return room.error();
    MovedRow& row = rows.emplace_back();
    row.scene = scene;
    if (auto status = Scene(*std::move(room), options).run(row); !status) return status.error();
  }
  return rows;
}

void print_table(const std::vector<MovedRow>& rows, std::ostream& out) {
  out << "             not moved        noticed of pushed, longest               should be borne\n"
         "scene        looks  alarms    2 cm           0.5 deg        1 cm           0.2 deg       "
         " "
         "CPU of a check\n";
  for (const MovedRow& row : rows) {
    out << fmt::format("{:<12} {:5}  {:6}    {}   {}   {}   {}   {:.1f} ms\n", row.scene,
                       row.checks, row.alarms, text_of(row.two_cm), text_of(row.half_degree),
                       text_of(row.one_cm), text_of(row.fifth_degree), row.detector_ms);
  }
}

void print_json(const std::vector<MovedRow>& rows, std::ostream& out) {
  nlohmann::json all = nlohmann::json::array();
  for (const MovedRow& row : rows) {
    all.push_back({{"scene", row.scene},
                   {"looks", row.checks},
                   {"alarms", row.alarms},
                   {"two_cm", json_of(row.two_cm)},
                   {"half_degree", json_of(row.half_degree)},
                   {"one_cm", json_of(row.one_cm)},
                   {"fifth_degree", json_of(row.fifth_degree)},
                   {"look_cpu_ms", row.detector_ms}});
  }
  out << nlohmann::json{{"rows", all}}.dump(2) << '\n';
}

}  // namespace roomcast::bench
