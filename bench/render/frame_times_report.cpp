// SPDX-License-Identifier: Apache-2.0
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/render/frame_times.h"

namespace roomcast::bench {
namespace {

nlohmann::json json_of(const Spread& spread) {
  return {{"median", spread.median}, {"p95", spread.p95}};
}

}  // namespace

void print_table(const FrameTimesReport& report, std::ostream& out) {
  out << fmt::format("{}: two eyes of {}x{}, simulated; {}\n", report.rig, report.eye_pixels,
                     report.eye_pixels, report.driver);
  out << fmt::format("{:>7} {:<8} {:>19} {:>19} {:>19}\n", "sensors", "mode", "with new frames",
                     "without", "GPU");
  const auto ms = [](const Spread& spread) {
    return fmt::format("{:.2f} / {:.2f} ms", spread.median, spread.p95);
  };
  for (const FrameTimesRow& row : report.rows) {
    out << fmt::format("{:>7} {:<8} {:>19} {:>19} {:>19}\n", row.sensors, row.mode,
                       ms(row.with_new_frames_ms), ms(row.without_ms), ms(row.gpu_ms));
  }
  out << "Median / 95th percentile until a picture of both eyes is finished. With new frames: all "
         "sensors' are uploaded.\n";
}

void print_json(const FrameTimesReport& report, std::ostream& out) {
  nlohmann::json json = {{"rig", report.rig},
                         {"driver", report.driver},
                         {"eye_pixels", report.eye_pixels},
                         {"rows", nlohmann::json::array()}};
  for (const FrameTimesRow& row : report.rows) {
    json["rows"].push_back({{"mode", row.mode},
                            {"sensors", row.sensors},
                            {"with_new_frames_ms", json_of(row.with_new_frames_ms)},
                            {"without_ms", json_of(row.without_ms)},
                            {"gpu_ms", json_of(row.gpu_ms)}});
  }
  out << json.dump(1) << "\n";
}

}  // namespace roomcast::bench
