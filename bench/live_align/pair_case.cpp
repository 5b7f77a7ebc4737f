// SPDX-License-Identifier: Apache-2.0
#include "bench/live_align/pair_case.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <ostream>
#include <tuple>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace roomcast::bench {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr int kBundleFrames = 7;
constexpr std::array<const char*, 4> kScenes = {"livingroom", "office", "lab", "studio"};
const Eigen::Vector3d kMiddle_m(0, 1, 0);  // of the room

double angle_between(const FilmedSensor& one, const FilmedSensor& other) {
  const Eigen::Vector3d a = one.world_from_depth().rotation.col(2);
  const Eigen::Vector3d b = other.world_from_depth().rotation.col(2);
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * kDegrees;
}

RigidTransform true_pose(const SensorPair& sensors) {
  return sensors.first.world_from_depth().inverse() * sensors.second.world_from_depth();
}

double error_mm(const SensorPair& sensors, const RigidTransform& a_from_b) {
  const Eigen::Vector3d middle = sensors.second.world_from_depth().inverse() * kMiddle_m;
  return 1000 * (a_from_b * middle - true_pose(sensors) * middle).norm();
}

Result<StillView> still_view(FilmedSensor& sensor) {
  auto bundle = sensor.bundle(kBundleFrames);
  if (!bundle) return bundle.error();
  auto view = alignment::make_sensor_view(*bundle);
  if (!view) return view.error();
  return StillView{*std::move(bundle), *std::move(view)};
}

struct Summary {
  int placed = 0;
  double median_mm = 0, worst_mm = 0;
};

Summary summary_of(const std::vector<PairCase>& cases) {
  std::vector<double> errors;
  for (const PairCase& one : cases) {
    if (one.placed) errors.push_back(one.error_mm);
  }
  if (errors.empty()) return {};
  std::ranges::sort(errors);
  return {static_cast<int>(errors.size()), errors[errors.size() / 2], errors.back()};
}

}  // namespace

Result<SensorPair> sensors_apart(const std::shared_ptr<const simulator::SimulatedRoom>& room,
                                 std::uint64_t seed, double apart_deg, int count) {
  std::vector<FilmedSensor> sensors;
  for (int i = 0; i < count; ++i) {
    simulator::SimulatedSensor::Options sensing;
    sensing.index = i;
    sensing.count = count;
    sensing.seed = seed;
    sensing.sensing.half_color = true;
    auto sensor = FilmedSensor::open(room, sensing);
    if (!sensor) return sensor.error();
    sensors.push_back(*std::move(sensor));
  }
  std::size_t a = 0, b = 1;
  const auto off = [&](std::size_t i, std::size_t j) {
    return std::abs(angle_between(sensors[i], sensors[j]) - apart_deg);
  };
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    for (std::size_t j = i + 1; j < sensors.size(); ++j) {
      if (off(i, j) < off(a, b)) std::tie(a, b) = std::pair(i, j);
    }
  }
  return SensorPair(std::move(sensors[a]), std::move(sensors[b]));
}

PairCase case_of(const std::string& scene, std::uint64_t seed, const SensorPair& sensors) {
  PairCase result;
  result.scene = scene;
  result.seed = seed;
  result.apart_deg = angle_between(sensors.first, sensors.second);
  return result;
}

Result<StillViews> still_views(SensorPair& sensors) {
  auto a = still_view(sensors.first), b = still_view(sensors.second);
  if (!a || !b) return (a ? b : a).error();
  return StillViews(*std::move(a), *std::move(b));
}

void place(const SensorPair& sensors, const alignment::EstimatedPlacement& a_from_b,
           PairCase& result) {
  result.placed = true;
  result.found_error_mm = result.error_mm = error_mm(sensors, a_from_b.world_from_depth);
  result.expected_error_mm = a_from_b.expected_error_mm;
  const Eigen::Matrix3d turned =
      a_from_b.world_from_depth.rotation.transpose() * true_pose(sensors).rotation;
  result.turn_error_deg = kDegrees * Eigen::AngleAxisd(turned).angle();
}

void place_refined(const SensorPair& sensors, const StillViews& views,
                   const alignment::EstimatedPlacement& a_from_b, PairCase& result) {
  const std::array placed = {alignment::PlacedView{&views.first.view, {}}};
  place(sensors,
        alignment::refined_placement(views.second.view, a_from_b, placed).value_or(a_from_b),
        result);
  result.found_error_mm = error_mm(sensors, a_from_b.world_from_depth);
}

Result<std::vector<PairCase>> run_rooms(
    int rooms, std::uint64_t first_seed,
    const std::function<Result<PairCase>(const char* scene, std::uint64_t seed)>& run_case,
    const std::function<void(std::string_view)>& progress) {
  std::vector<PairCase> cases;
  constexpr std::uint64_t kMaxTried = 10;  // per wanted room
  for (std::uint64_t i = 0; std::ssize(cases) < rooms; ++i) {
    const char* scene = kScenes[i % kScenes.size()];
    progress(fmt::format("room {} of {}: {}", cases.size() + 1, rooms, scene));
    auto one = run_case(scene, first_seed + i);
    const bool nobody_walks = !one && one.error().code == ErrorCode::kInvalidArgument;
    if (nobody_walks && i < kMaxTried * static_cast<std::uint64_t>(rooms)) continue;
    if (!one) return one.error();
    cases.push_back(*std::move(one));
  }
  return cases;
}

void print_table(const std::vector<PairCase>& cases, std::ostream& out) {
  out << "scene       seed  apart   error   expected   turn      before it settled\n";
  for (const PairCase& one : cases) {
    const std::string figures =
        one.placed ? fmt::format("{:5.1f} mm  {:5.1f} mm  {:5.2f} deg  {:5.1f} mm", one.error_mm,
                                 one.expected_error_mm, one.turn_error_deg, one.found_error_mm)
                   : "refused: " + one.reason;
    out << fmt::format("{:<10} {:5}  {:3.0f} deg  {}\n", one.scene, one.seed, one.apart_deg,
                       figures);
  }
  const Summary summary = summary_of(cases);
  out << fmt::format(
      "{} of {} placed, error at the middle of the room: median {:.1f} mm, worst {:.1f} mm\n",
      summary.placed, cases.size(), summary.median_mm, summary.worst_mm);
}

void print_json(const std::vector<PairCase>& cases, std::ostream& out) {
  nlohmann::json rows = nlohmann::json::array();
  for (const PairCase& one : cases) {
    rows.push_back({{"scene", one.scene},
                    {"seed", one.seed},
                    {"apart_deg", one.apart_deg},
                    {"placed", one.placed},
                    {"reason", one.reason},
                    {"error_mm", one.error_mm},
                    {"turn_error_deg", one.turn_error_deg},
                    {"expected_error_mm", one.expected_error_mm},
                    {"found_error_mm", one.found_error_mm},
                    {"look_cpu_ms", one.detector_ms}});
  }
  const Summary summary = summary_of(cases);
  out << nlohmann::json{{"rows", rows},
                        {"placed", summary.placed},
                        {"median_error_mm", summary.median_mm},
                        {"worst_error_mm", summary.worst_mm}}
             .dump(2)
      << '\n';
}

}  // namespace roomcast::bench
