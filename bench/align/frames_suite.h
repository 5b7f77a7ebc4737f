// SPDX-License-Identifier: Apache-2.0
// How much alignment depends on which frames of a recorded rig it gets: draws of consecutive
// frames, spread evenly over the recording, and all frames. Poses are compared with the rig's truth
// where it has one, with each other, and with a ball that two sensors saw at the same time
// (kinects3 of the shared data). The ball and the truth are never given to alignment. Metres, frame
// numbers. Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "bench/align/align_bench.h"
#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/alignment/rig/alignment_report.h"

namespace roomcast::bench {

/// Where a sensor saw the centre of the ball, by its own depth.
struct BallSighting {
  std::size_t sensor = 0;
  std::uint64_t frame = 0;
  Eigen::Vector3d center_m = Eigen::Vector3d::Zero();  // in the depth frame
};

/// Frame numbers first .. first + count - 1.
struct FrameWindow {
  std::uint64_t first = 0, count = 0;
};

/// A recorded rig. `bundle` reads one sensor's frames of a window.
struct FramesRig {
  std::string name;
  std::vector<std::string> sensors;
  std::vector<std::optional<RigidTransform>> world_from_depth;  // the truth, by sensor
  std::uint64_t frames = 0;                                     // numbers are 0 .. frames - 1
  std::vector<BallSighting> ball;
  std::function<Result<alignment::CalibrationBundle>(std::size_t sensor, const FrameWindow&)>
      bundle;
};

struct FramesSuiteOptions {
  int draws = 20;
  std::uint64_t frames = 12;  // of a draw
};

/// The first frames of the draws: spread evenly, each once; fewer than asked for when the recording
/// is short, one that has all frames when it is shorter than a draw.
[[nodiscard]] std::vector<FrameWindow> spread_windows(std::uint64_t frames,
                                                      const FramesSuiteOptions& options);

/// What alignment said with the frames of one window.
struct FramesAnswer {
  FrameWindow window;
  std::vector<alignment::SensorReport> sensors;  // of the rig, in its order
  double scale_error = 0;
};

/// Alignment of a pair over the draws.
struct FramesPairRow {
  std::string a, b;
  int draws = 0, answered = 0;
  bool has_truth = false;
  int wrong = 0;                              // with truth
  std::vector<double> errors_mm, errors_deg;  // with truth: 2.5 m ahead of b
  std::vector<double> spread_mm;              // 2.5 m ahead of b: distances from the median place
  std::vector<double> ball_mm;                // by draw: median distance of the ball's two places
  std::vector<double> said_mm;                // expected errors of b, or of a where b is the origin
  std::vector<double> errors_over_said;       // with truth (said_error.h), else of the ball
};

struct FramesRigRow {
  std::string rig;
  int draws = 0, sensors = 0;
  int placed = 0;                                 // of draws * sensors
  int complete = 0;                               // draws in which all sensors are placed
  std::vector<std::vector<double>> depth_scales;  // by sensor: of the draws that place it
  std::vector<FramesPairRow> pairs;               // over the draws
  std::vector<FramesPairRow> all;                 // with all frames of the recording
};

/// The rows of the pairs of a rig, over some answers.
[[nodiscard]] std::vector<FramesPairRow> frames_pairs(const FramesRig& rig,
                                                      const std::vector<FramesAnswer>& answers);

/// Sensors without a usable bundle count as not placed.
[[nodiscard]] FramesRigRow run_frames_suite(const FramesRig& rig, const FramesSuiteOptions& options,
                                            const BenchProgress& progress);

void print_table(const std::vector<FramesRigRow>& rows, std::ostream& out);
void print_json(const std::vector<FramesRigRow>& rows, std::ostream& out);

}  // namespace roomcast::bench
