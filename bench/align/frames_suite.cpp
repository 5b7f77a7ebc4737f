// SPDX-License-Identifier: Apache-2.0
#include "bench/align/frames_suite.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "bench/align/align_tally.h"
#include "bench/align/depth_scale_of.h"
#include "bench/align/said_error.h"
#include "roomcast/alignment/pair/pose_difference.h"
#include "roomcast/alignment/rig/rig_aligner.h"

namespace roomcast::bench {
namespace {

const Eigen::Vector3d kAhead_m(0, 0, 2.5);  // where views usually have something

FramesAnswer answer_with(const FramesRig& rig, const FrameWindow& window) {
  alignment::RigAligner aligner({}, alignment::DepthScaling::kEstimated);
  FramesAnswer answer{window, std::vector<alignment::SensorReport>(rig.sensors.size()), 0};
  std::vector<std::size_t> given;
  for (std::size_t i = 0; i < rig.sensors.size(); ++i) {
    answer.sensors[i].id = rig.sensors[i];
    const auto bundle = rig.bundle(i, window);
    if (!bundle) continue;
    auto view = alignment::make_sensor_view(*bundle);
    if (!view) continue;
    aligner.add(std::make_shared<const alignment::SensorView>(*std::move(view)));
    given.push_back(i);
  }
  const alignment::AlignmentReport report = aligner.solve();
  for (std::size_t i = 0; i < given.size(); ++i) answer.sensors[given[i]] = report.sensors[i];
  answer.scale_error = report.scale_error;
  return answer;
}

std::optional<RigidTransform> a_from_b_of(const FramesAnswer& answer, std::size_t a,
                                          std::size_t b) {
  const auto &of_a = answer.sensors[a].world_from_depth, &of_b = answer.sensors[b].world_from_depth;
  if (!of_a || !of_b) return std::nullopt;
  return of_a->inverse() * *of_b;
}

/// The median distance between the two places where a and b put the ball; nothing if they never saw
/// it together.
std::optional<double> ball_distance_mm(const FramesRig& rig, const FramesAnswer& answer,
                                       std::size_t a, std::size_t b) {
  const auto put = [&](const BallSighting& seen) -> Eigen::Vector3d {
    const alignment::SensorReport& sensor = answer.sensors[seen.sensor];
    return *sensor.world_from_depth * (depth_scale_of(sensor) * seen.center_m);
  };
  std::vector<double> distances_mm;
  for (const BallSighting& by_a : rig.ball) {
    for (const BallSighting& by_b : rig.ball) {
      if (by_a.sensor != a || by_b.sensor != b || by_a.frame != by_b.frame) continue;
      distances_mm.push_back(1000 * (put(by_a) - put(by_b)).norm());
    }
  }
  if (distances_mm.empty()) return std::nullopt;
  return median(distances_mm);
}

/// Distances of places from the median place, coordinate by coordinate.
std::vector<double> distances_from_median_mm(const std::vector<Eigen::Vector3d>& places_m) {
  Eigen::Vector3d middle_m;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& place : places_m) values.push_back(place[axis]);
    middle_m[axis] = median(values);
  }
  std::vector<double> distances_mm;
  for (const Eigen::Vector3d& place : places_m)
    distances_mm.push_back(1000 * (place - middle_m).norm());
  return distances_mm;
}

FramesPairRow pair_row(const FramesRig& rig, const std::vector<FramesAnswer>& answers,
                       std::size_t a, std::size_t b) {
  FramesPairRow row;
  row.a = rig.sensors[a];
  row.b = rig.sensors[b];
  std::optional<RigidTransform> truth;
  if (rig.world_from_depth[a] && rig.world_from_depth[b])
    truth = rig.world_from_depth[a]->inverse() * *rig.world_from_depth[b];
  row.has_truth = truth.has_value();
  std::vector<Eigen::Vector3d> ahead_m;
  for (const FramesAnswer& answer : answers) {
    ++row.draws;
    const auto found = a_from_b_of(answer, a, b);
    if (!found) continue;
    ++row.answered;
    ahead_m.push_back(*found * kAhead_m);
    row.said_mm.push_back(
        std::max(answer.sensors[a].expected_error_mm, answer.sensors[b].expected_error_mm));
    if (const auto ball = ball_distance_mm(rig, answer, a, b)) {
      row.ball_mm.push_back(*ball);
      // All that both sensors measure shares the room's scale, so its error is not seen here.
      if (!truth) row.errors_over_said.push_back(*ball / std::max(0.01, row.said_mm.back()));
    }
    if (!truth) continue;
    row.wrong += !is_right(*found, *truth);
    const auto error = alignment::difference(*found, *truth, kAhead_m);
    row.errors_mm.push_back(1000 * error.distance_m);
    row.errors_deg.push_back(error.angle_rad * 180 / std::numbers::pi);
    const double said_mm =
        said_of(answer.sensors[a], answer.sensors[b], *found, answer.scale_error);
    row.errors_over_said.push_back(row.errors_mm.back() / std::max(0.01, said_mm));
  }
  if (!ahead_m.empty()) row.spread_mm = distances_from_median_mm(ahead_m);
  return row;
}

void count_placed(const FramesAnswer& answer, FramesRigRow& row) {
  bool all = true;
  for (std::size_t i = 0; i < answer.sensors.size(); ++i) {
    const alignment::SensorReport& sensor = answer.sensors[i];
    row.placed += sensor.placed;
    all = all && sensor.placed;
    if (sensor.placed) row.depth_scales[i].push_back(depth_scale_of(sensor));
  }
  row.complete += all;
}

}  // namespace

std::vector<FrameWindow> spread_windows(std::uint64_t frames, const FramesSuiteOptions& options) {
  if (frames <= options.frames) return {{0, frames}};
  const std::uint64_t last = frames - options.frames;
  const auto draws = static_cast<std::uint64_t>(options.draws);
  std::vector<FrameWindow> windows;
  for (std::uint64_t i = 0; i < draws; ++i) {
    const std::uint64_t first = draws > 1 ? (last * i + (draws - 1) / 2) / (draws - 1) : last / 2;
    if (windows.empty() || windows.back().first != first)
      windows.push_back({first, options.frames});
  }
  return windows;
}

std::vector<FramesPairRow> frames_pairs(const FramesRig& rig,
                                        const std::vector<FramesAnswer>& answers) {
  std::vector<FramesPairRow> rows;
  for (std::size_t a = 0; a < rig.sensors.size(); ++a) {
    for (std::size_t b = a + 1; b < rig.sensors.size(); ++b)
      rows.push_back(pair_row(rig, answers, a, b));
  }
  return rows;
}

FramesRigRow run_frames_suite(const FramesRig& rig, const FramesSuiteOptions& options,
                              const BenchProgress& progress) {
  FramesRigRow row;
  row.rig = rig.name;
  row.sensors = static_cast<int>(rig.sensors.size());
  row.depth_scales.resize(rig.sensors.size());
  std::vector<FramesAnswer> answers;
  const auto windows = spread_windows(rig.frames, options);
  for (const FrameWindow& window : windows) {
    if (progress)
      progress(fmt::format("{}: draw {} of {}", rig.name, answers.size() + 1, windows.size()));
    answers.push_back(answer_with(rig, window));
    count_placed(answers.back(), row);
  }
  row.draws = static_cast<int>(answers.size());
  row.pairs = frames_pairs(rig, answers);
  if (progress) progress(rig.name + ": all frames");
  row.all = frames_pairs(rig, {answer_with(rig, {0, rig.frames})});
  return row;
}

}  // namespace roomcast::bench
