// SPDX-License-Identifier: Apache-2.0
#include "bench/real/real_bench.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "bench/codec/bench_input.h"
#include "bench/real/rig_depth.h"
#include "roomcast/recording/dataset/rig_json.h"
#include "roomcast/render/gl/gl_context.h"

namespace roomcast::bench {
namespace {

using Progress = std::function<void(const std::string&)>;

constexpr double kPlayedFps = 30;

/// By roomcast's own codecs. The recording is played forward and backward at 30 frames/s: colour's
/// bit rate is one of time, and few recordings of rigs last longer than a second or state their
/// rate.
Result<SensorBytes> measure_bytes(const std::filesystem::path& rig, const std::string& sensor,
                                  int frames, const Progress& progress) {
  auto input =
      open_bench_input("rig:" + rig.string() + "#" + sensor, {.back_and_forth_fps = kPlayedFps});
  if (!input) return input.error();
  const CodecBenchOptions options{.only = "roomcast", .most_frames = frames};
  auto report = run_codec_bench(**input, options, [&](int frame) {
    if (progress) progress(fmt::format("{}: codecs, frame {}", sensor, frame));
  });
  if (!report) return report.error();
  return SensorBytes{sensor, std::move(report->rows)};
}

/// The rig's placed sensors, with the poses that alignment gave them.
recording::RigDescription placed_part(const recording::RigDescription& rig,
                                      const alignment::AlignmentReport& alignment) {
  recording::RigDescription placed = rig;
  placed.sensors.clear();
  for (recording::RigSensorEntry entry : rig.sensors) {
    const auto found = std::ranges::find(alignment.sensors, entry.id, &alignment::SensorReport::id);
    if (found == alignment.sensors.end() || !found->placed) continue;
    entry.world_from_depth = found->world_from_depth;
    placed.sensors.push_back(std::move(entry));
  }
  return placed;
}

/// The factor on the sensor's readings that its pose assumes.
double assumed_depth_scale(const std::string& sensor, const RealReport& report) {
  const auto& sensors = report.alignment.sensors;
  const auto found = std::ranges::find(sensors, sensor, &alignment::SensorReport::id);
  return found == sensors.end() ? 1 : found->depth_scale;
}

Status draw_left_out(const std::filesystem::path& folder, const recording::RigDescription& placed,
                     int pictures, const Progress& progress, RealReport& report) {
  if (pictures == 0) {
    report.not_drawn = "no pictures were asked for";
    return {};
  }
  if (placed.sensors.size() < 2) {
    report.not_drawn = "fewer than two sensors have a pose";
    return {};
  }
  const auto context = render::EglContext::create();
  if (!context) {
    report.not_drawn = context.error().message;
    return {};
  }
  auto frames = RigFrames::open(folder, placed, 1);
  if (!frames) return frames.error();
  for (std::size_t s = 0; s < placed.sensors.size(); ++s)
    RigFrames::scale_depth(frames->sensors()[s], assumed_depth_scale(placed.sensors[s].id, report));
  for (std::size_t s = 0; s < placed.sensors.size(); ++s) {
    auto drawn = draw_without(*frames, s, pictures, progress);
    if (!drawn) return drawn.error();
    std::ranges::move(*drawn, std::back_inserter(report.left_out));
  }
  return {};
}

}  // namespace

Result<RealReport> run_real_bench(const std::filesystem::path& rig,
                                  const alignment::AlignmentReport& alignment,
                                  const RealBenchOptions& options, const Progress& progress) {
  const auto description = recording::read_rig_json(rig / "rig.json");
  if (!description) return description.error();
  RealReport report;
  report.rig = std::filesystem::absolute(rig).lexically_normal().filename().string();
  report.source = description->source;
  report.alignment = alignment;
  auto judgement = judge_rig(rig, *description, alignment);
  if (!judgement) return judgement.error();
  report.judgement = *std::move(judgement);
  for (const recording::RigSensorEntry& sensor : description->sensors) {
    if (!options.conditions) break;
    if (progress) progress(sensor.id + ": noise, interference and motion");
    const auto depth = read_rig_depth(rig, sensor.id);
    if (!depth) return depth.error();
    report.conditions.push_back(condition_of(sensor.id, depth->frames));
    report.motion.push_back(forecast_motion(sensor.id, depth->lens, depth->frames));
  }
  for (const recording::RigSensorEntry& sensor : description->sensors) {
    if (options.codec_frames == 0) break;
    auto bytes = measure_bytes(rig, sensor.id, options.codec_frames, progress);
    if (!bytes) return bytes.error();
    report.bytes.push_back(*std::move(bytes));
  }
  auto drawn = draw_left_out(rig, placed_part(*description, alignment), options.left_out_pictures,
                             progress, report);
  if (!drawn) return drawn.error();
  return report;
}

}  // namespace roomcast::bench
