// SPDX-License-Identifier: Apache-2.0
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/model/model_bench.h"

namespace roomcast::bench {
namespace {

nlohmann::json json_of(const ScoreFigures& score) {
  return {{"median_mm", score.median_mm}, {"p90_mm", score.p90_mm},
          {"coverage", score.coverage},   {"coverage_of_read_once", score.coverage_once},
          {"floating", score.floating},   {"pixels", score.pixels}};
}

nlohmann::json json_of(const ColorStep& step) {
  return {{"mean", step.mean}, {"largest", step.largest}};
}

std::string text_of(const ScoreFigures& score) {
  if (score.pixels == 0) return "-";
  return fmt::format("{:.1f} / {:.1f} mm, {:.1f} %, {:.2f} %", score.median_mm, score.p90_mm,
                     100 * score.coverage, 100 * score.floating);
}

}  // namespace

void print_table(const std::vector<ModelRow>& rows, std::ostream& out) {
  out << "simulated; median / 90 % of the errors, coverage of what was seen, floating\n";
  out << fmt::format("{:<14} {:>6} {:>32} {:>32} {:>8} {:>10} {:>8} {:>9} {:>8}\n", "rig", "frames",
                     "from the sensors", "from free viewpoints", "volume", "triangles", "file",
                     "frame", "fusing");
  for (const ModelRow& row : rows) {
    out << fmt::format(
        "{:<14} {:>6} {:>32} {:>32} {:>5.0f} MB {:>10} {:>5.2f} MB {:>6.1f} ms {:>6.1f} s\n",
        row.rig, row.frames, text_of(row.sensors), text_of(row.free),
        1e-6 * static_cast<double>(row.volume_bytes), row.triangles,
        1e-6 * static_cast<double>(row.file_bytes), row.frame_cpu_ms, row.fuse_cpu_s);
  }
  for (const ModelRow& row : rows) {
    out << fmt::format(
        "{:<14} colour steps between views, mean and largest of {} pairs: {:.1f}, {:.1f} levels; "
        "with gains {:.1f}, {:.1f}\n",
        row.rig, row.colors.pairs, row.colors.before.mean, row.colors.before.largest,
        row.colors.after.mean, row.colors.after.largest);
  }
}

void print_json(const std::vector<ModelRow>& rows, std::ostream& out) {
  auto json = nlohmann::json::array();
  for (const ModelRow& row : rows) {
    json.push_back({{"rig", row.rig},
                    {"views", row.views},
                    {"frames", row.frames},
                    {"sensors", json_of(row.sensors)},
                    {"free", json_of(row.free)},
                    {"volume_bytes", row.volume_bytes},
                    {"points", row.points},
                    {"triangles", row.triangles},
                    {"file_bytes", row.file_bytes},
                    {"color_step_pairs", row.colors.pairs},
                    {"color_step", json_of(row.colors.before)},
                    {"color_step_with_gains", json_of(row.colors.after)},
                    {"frame_cpu_ms", row.frame_cpu_ms},
                    {"fuse_cpu_s", row.fuse_cpu_s}});
  }
  out << json.dump(1) << "\n";
}

}  // namespace roomcast::bench
