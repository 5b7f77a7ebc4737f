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
          {"reason", sensor.reason}};
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

ordered_json report_json(const RealReport& report) {
  return {{"rig", report.rig},
          {"source", report.source},
          {"sensors", list_json(report.alignment.sensors, sensor_json)},
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

}  // namespace

void print_table(const RealReport& report, std::ostream& out) {
  fmt::print(out, "{}{}\n", report.rig, report.source.empty() ? "" : " (" + report.source + ")");
  for (const auto& sensor : report.alignment.sensors) print_sensor(sensor, out);
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
