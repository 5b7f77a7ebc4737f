// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <nlohmann/json.hpp>

#include "bench/real/real_bench.h"

namespace roomcast::bench {
namespace {

using nlohmann::ordered_json;

ordered_json if_number(double value) {
  return std::isnan(value) ? ordered_json() : ordered_json(value);
}

ordered_json sensor_json(const alignment::SensorReport& sensor) {
  return {{"id", sensor.id},
          {"placed", sensor.placed},
          {"expected_error_mm", sensor.expected_error_mm},
          {"expected_error_deg", sensor.expected_error_deg},
          {"depth_scale", sensor.depth_scale},
          {"depth_scale_standard_error", sensor.depth_scale_standard_error},
          {"reason", sensor.reason}};
}

ordered_json ball_json(const BallGap& gap) {
  return {{"a", gap.a},
          {"b", gap.b},
          {"instants", gap.instants},
          {"median_mm", gap.median_mm},
          {"expected_mm", gap.expected_mm}};
}

ordered_json known_json(const PoseGap& gap) {
  return {{"sensor", gap.sensor},
          {"from_known_mm", gap.from_known_mm},
          {"from_known_deg", gap.from_known_deg}};
}

ordered_json loop_json(const Loop& loop) {
  return {{"sensors", {loop.a, loop.b, loop.c}},
          {"closure_mm", loop.closure_mm},
          {"closure_deg", loop.closure_deg}};
}

ordered_json interference_json(const sensor::InterferenceFigures& figures) {
  if (!figures.is_known) return nullptr;
  return {{"flickering", figures.flickering}, {"noise_ratio", figures.noise_ratio}};
}

ordered_json noise_json(const NoiseAtDistance& noise) {
  return {{"distance_m", noise.distance_m}, {"sigma_mm", noise.sigma_mm}, {"share", noise.share}};
}

ordered_json bytes_json(const SensorBytes& bytes) {
  ordered_json rows = ordered_json::array();
  for (const CodecBenchRow& row : bytes.rows) {
    rows.push_back({{"codec", row.codec},
                    {"mode", row.mode},
                    {"depth_bytes", row.depth_bytes},
                    {"color_bytes", row.color_bytes},
                    {"mb_per_s", row.mb_per_s}});
  }
  return {{"sensor", bytes.sensor}, {"codecs", rows}};
}

ordered_json picture_json(const LeftOutPicture& picture) {
  return {{"sensor", picture.sensor},
          {"frame", picture.frame},
          {"psnr_db", if_number(picture.psnr_db)},
          {"ssim", if_number(picture.ssim)},
          {"covered", picture.covered},
          {"wrong_depth", picture.wrong_depth}};
}

template <class Items, class ToJson>
ordered_json list_json(const Items& items, ToJson to_json) {
  ordered_json list = ordered_json::array();
  for (const auto& item : items) list.push_back(to_json(item));
  return list;
}

ordered_json condition_json(const SensorCondition& condition) {
  return {{"sensor", condition.sensor},
          {"noise", list_json(condition.noise, noise_json)},
          {"interference", interference_json(condition.interference)},
          {"interference_after_filter", interference_json(condition.filtered)},
          {"held", condition.held},
          {"changed", condition.changed}};
}

ordered_json motion_json(const MotionForecast& motion) {
  return {{"sensor", motion.sensor},
          {"moving", motion.moving},
          {"off_unmoved", motion.off_unmoved},
          {"off_moved", motion.off_moved}};
}

ordered_json report_json(const RealReport& report) {
  return {{"rig", report.rig},
          {"source", report.source},
          {"sensors", list_json(report.alignment.sensors, sensor_json)},
          {"ball", list_json(report.judgement.ball, ball_json)},
          {"known_poses", list_json(report.judgement.known, known_json)},
          {"loops", list_json(report.judgement.loops, loop_json)},
          {"conditions", list_json(report.conditions, condition_json)},
          {"motion", list_json(report.motion, motion_json)},
          {"bytes", list_json(report.bytes, bytes_json)},
          {"left_out", list_json(report.left_out, picture_json)},
          {"not_drawn", report.not_drawn}};
}

void print_sensor(const alignment::SensorReport& sensor, std::ostream& out) {
  if (sensor.placed) {
    fmt::print(out, "  {:<8} placed, expected error {:.0f} mm and {:.2f} degrees\n", sensor.id,
               sensor.expected_error_mm, sensor.expected_error_deg);
  } else {
    fmt::print(out, "  {:<8} not placed: {}\n", sensor.id, sensor.reason);
  }
}

void print_judgement(const RigJudgement& judgement, std::ostream& out) {
  for (const BallGap& gap : judgement.ball) {
    fmt::print(out, "  ball      {} and {}: {:.0f} mm apart, median of {}; expected {:.0f}\n",
               gap.a, gap.b, gap.median_mm, gap.instants, gap.expected_mm);
  }
  for (const PoseGap& gap : judgement.known) {
    fmt::print(out, "  known     {}: {:.0f} mm and {:.2f} degrees from the recording's pose\n",
               gap.sensor, gap.from_known_mm, gap.from_known_deg);
  }
  for (const Loop& loop : judgement.loops) {
    fmt::print(out, "  loop      {}, {}, {}: open by {:.0f} mm and {:.2f} degrees\n", loop.a,
               loop.b, loop.c, loop.closure_mm, loop.closure_deg);
  }
}

void print_condition(const SensorCondition& sensor, std::ostream& out) {
  fmt::print(out, "  {:<8} noise", sensor.sensor);
  for (const NoiseAtDistance& noise : sensor.noise)
    fmt::print(out, " {:.1f} mm at {:.2g} m,", noise.sigma_mm, noise.distance_m);
  if (!sensor.interference.is_known) {
    fmt::print(out, " interference unknown\n");
    return;
  }
  fmt::print(out,
             " {:.2f} % of still readings come and go ({:.2f} % after the filter), noise up to "
             "{:.2f} times the usual\n",
             100 * sensor.interference.flickering, 100 * sensor.filtered.flickering,
             sensor.interference.noise_ratio);
}

void print_motion(const MotionForecast& sensor, std::ostream& out) {
  if (sensor.moving == 0) return;
  fmt::print(
      out,
      "  {:<8} motion: of {} readings that move, the next frame shows {:.1f} % elsewhere by 4 "
      "cm and more; where motion says they will be, {:.1f} %\n",
      sensor.sensor, sensor.moving, 100 * sensor.off_unmoved, 100 * sensor.off_moved);
}

}  // namespace

void print_table(const RealReport& report, std::ostream& out) {
  fmt::print(out, "{}{}\n", report.rig, report.source.empty() ? "" : " (" + report.source + ")");
  for (const auto& sensor : report.alignment.sensors) print_sensor(sensor, out);
  print_judgement(report.judgement, out);
  for (const SensorCondition& sensor : report.conditions) print_condition(sensor, out);
  for (const MotionForecast& sensor : report.motion) print_motion(sensor, out);
  if (!report.bytes.empty()) {
    fmt::print(out, "\n  {:<8} {:<10} {:<11} {:>13} {:>13} {:>8}\n", "sensor", "codec", "mode",
               "depth B/frame", "color B/frame", "MB/s@30");
  }
  for (const SensorBytes& bytes : report.bytes) {
    for (const CodecBenchRow& row : bytes.rows) {
      fmt::print(out, "  {:<8} {:<10} {:<11} {:>13.0f} {:>13.0f} {:>8.2f}\n", bytes.sensor,
                 row.codec, row.mode, row.depth_bytes, row.color_bytes, row.mb_per_s);
    }
  }
  if (!report.not_drawn.empty()) {
    fmt::print(out, "\n  No sensor was left out and drawn: {}\n", report.not_drawn);
    return;
  }
  fmt::print(out, "\n  {:<8} {:>6} {:>8} {:>6} {:>8} {:>12}\n", "left out", "frame", "PSNR dB",
             "SSIM", "covered", "wrong depth");
  for (const LeftOutPicture& picture : report.left_out) {
    fmt::print(out, "  {:<8} {:>6} {:>8.1f} {:>6.2f} {:>6.0f} % {:>10.1f} %\n", picture.sensor,
               picture.frame, picture.psnr_db, picture.ssim, 100 * picture.covered,
               100 * picture.wrong_depth);
  }
}

void print_json(const std::vector<RealReport>& reports, std::ostream& out) {
  out << list_json(reports, report_json).dump(2) << '\n';
}

}  // namespace roomcast::bench
