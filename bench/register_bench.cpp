// SPDX-License-Identifier: Apache-2.0
#include "bench/register_bench.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <utility>

#include "roomcast/geometry/registration.h"
#include "roomcast/geometry/registration_reference.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::bench {
namespace {

double thread_cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Calls `run(i)` for inputs 0, 1, ... `count` - 1 repeatedly and returns the median time of a
/// call.
double median_cpu_ms(std::size_t count, double budget_s,
                     const std::function<void(std::size_t)>& run) {
  std::vector<double> times_ms;
  const double begin = thread_cpu_seconds();
  double before = begin;
  do {
    run(times_ms.size() % count);
    const double after = thread_cpu_seconds();
    times_ms.push_back(1000 * (after - before));
    before = after;
  } while (before - begin < budget_s || times_ms.size() < count);
  const auto middle = times_ms.begin() + static_cast<std::ptrdiff_t>(times_ms.size() / 2);
  std::nth_element(times_ms.begin(), middle, times_ms.end());
  return *middle;
}

double seen_share(const DepthImage& depth_mm, const RegisteredColor& registered) {
  const std::size_t count = depth_mm.view().pixel_count();
  std::size_t with_depth = 0, seen = 0;
  for (std::size_t i = 0; i < count; ++i) {
    with_depth += depth_mm.data()[i] != 0 ? 1 : 0;
    seen += registered.seen.data()[i] != 0 ? 1 : 0;
  }
  return with_depth == 0 ? 0 : static_cast<double>(seen) / static_cast<double>(with_depth);
}

RegisterBenchRow row(const std::string& input, const char* version, double cpu_ms) {
  return {input, version, cpu_ms, 1000 / cpu_ms, 1, 0};
}

Result<std::vector<RegisterBenchRow>> measure(const RegisterBenchInput& input, double budget_s) {
  auto registration = Registration::create(input.calibration);
  if (!registration.ok()) return registration.error();
  RegisteredColor out;
  const source::CapturedFrame& first = input.frames.front();
  if (Status s = registration->run(first.depth_mm, first.color, out); !s.ok()) return s.error();
  const double share = seen_share(first.depth_mm, out);

  Status last;
  const std::size_t count = input.frames.size();
  const double fast_ms = median_cpu_ms(count, budget_s, [&](std::size_t i) {
    Status status = registration->run(input.frames[i].depth_mm, input.frames[i].color, out);
    if (!status.ok()) last = std::move(status);
  });
  if (!last.ok()) return last.error();
  const RegistrationReference reference(input.calibration, {});
  const double plain_ms = median_cpu_ms(count, budget_s, [&](std::size_t i) {
    out = reference.run(input.frames[i].depth_mm, input.frames[i].color);
  });

  std::vector<RegisterBenchRow> rows = {row(input.name, "fast", fast_ms),
                                        row(input.name, "reference", plain_ms)};
  rows[0].times_reference = plain_ms / fast_ms;
  for (RegisterBenchRow& each : rows) each.seen_share = share;
  return rows;
}

/// Boxes in front of a wall and a floor: steps, slopes and occlusion in every part of the picture.
std::uint16_t invented_depth_mm(int x, int y) {
  const bool box = (x / 60 + y / 50) % 4 == 0;
  if (box) return static_cast<std::uint16_t>(1200 + x / 8);
  const int floor_mm = y > 250 ? 1'100'000 / (y - 20) : 5000;
  return static_cast<std::uint16_t>(std::min(3500 + x / 4, floor_mm));
}

}  // namespace

RegisterBenchInput synthetic_kinect_v2_input() {
  RegisterBenchInput input;
  input.name = "synthetic";
  input.calibration.depth = {512,    424,     364.478, 364.478, 252.95, 205.88,
                             0.0984, -0.2811, 0.0952,  0,       0};
  input.calibration.color = {1920, 1080, 1066, 1066, 958.5, 545, 0.0179, -0.0332, 0, 0.0001, 0};
  input.calibration.color_from_depth.translation_m = {-0.052, 0.0002, -0.0005};
  source::CapturedFrame frame;
  frame.depth_mm.resize(512, 424);
  for (int y = 0; y < 424; ++y) {
    for (int x = 0; x < 512; ++x) frame.depth_mm.at(x, y) = invented_depth_mm(x, y);
  }
  frame.color.resize(1920, 1080);
  for (int v = 0; v < 1080; ++v) {
    for (int u = 0; u < 1920; ++u) {
      frame.color.at(u, v) = {static_cast<std::uint8_t>(u * v >> 4), static_cast<std::uint8_t>(u),
                              static_cast<std::uint8_t>(v)};
    }
  }
  input.frames.push_back(std::move(frame));
  return input;
}

Result<RegisterBenchInput> recorded_input(const std::string& source_spec, int most_frames) {
  auto source =
      sensor::open_source(source_spec, {.pace = source::Pace::kAsFastAsPossible, .loop = false});
  if (!source.ok()) return source.error();
  RegisterBenchInput input{source_spec, (*source)->description().calibration, {}};
  source::CapturedFrame frame;
  while (static_cast<int>(input.frames.size()) < most_frames) {
    const auto more = (*source)->next(frame, {});
    if (!more.ok()) return more.error();
    if (!*more) break;
    if (!frame.color.empty()) input.frames.push_back(frame);
  }
  if (input.frames.empty()) {
    return Error{ErrorCode::kInvalidArgument, source_spec + " has no frame with colour"};
  }
  return input;
}

Result<RegisterBenchReport> run_register_bench(const std::vector<RegisterBenchInput>& inputs,
                                               const RegisterBenchOptions& options) {
  RegisterBenchReport report;
  for (const RegisterBenchInput& input : inputs) {
    const CameraIntrinsics &depth = input.calibration.depth, &color = input.calibration.color;
    if (&input == &inputs.front()) {
      report = {depth.width, depth.height, color.width, color.height, {}};
    }
    if (input.frames.empty() || depth.width != report.depth_width ||
        depth.height != report.depth_height || color.width != report.color_width ||
        color.height != report.color_height) {
      return Error{ErrorCode::kInvalidArgument,
                   input.name + " has no frames, or frames of another size than the first input"};
    }
    auto rows = measure(input, options.cpu_seconds_per_row);
    if (!rows.ok()) return rows.error();
    report.rows.insert(report.rows.end(), rows->begin(), rows->end());
  }
  return report;
}

}  // namespace roomcast::bench
