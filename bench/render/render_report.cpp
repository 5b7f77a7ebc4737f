// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <ostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/render/render_bench.h"

namespace roomcast::bench {
namespace {

double cost_vs_points(const RenderRow& row) {
  return row.points_cpu_ms > 0 ? row.draw_cpu_ms / row.points_cpu_ms : 0;
}

/// Cost of drawing both eyes at once, relative to drawing one after the other; 0: not measured.
double stereo_vs_two(const RenderRow& row) {
  const StereoCost& cost = row.stereo;
  return cost.one_by_one_cpu_ms > 0 ? cost.at_once_cpu_ms / cost.one_by_one_cpu_ms : 0;
}

void print_stereo(const RenderReport& report, std::ostream& out) {
  for (const RenderRow& row : report.rows) {
    if (row.stereo.one_by_one_cpu_ms == 0) continue;
    out << fmt::format("{:<8} two eyes at once {:.0f} ms, one after the other {:.0f} ms: {:.2f}\n",
                       row.mode, row.stereo.at_once_cpu_ms, row.stereo.one_by_one_cpu_ms,
                       stereo_vs_two(row));
  }
}

}  // namespace

void print_table(const RenderReport& report, std::ostream& out) {
  out << fmt::format("{}: {} sensors, {} views of {}x{}, simulated; {}\n", report.rig,
                     report.sensors, report.views, report.width, report.height, report.driver);
  out << fmt::format(
      "{:<8} {:>13} {:>13} {:>13} {:>7} {:>7} {:>8} {:>7} {:>12} {:>8} {:>9} {:>8} {:>8}\n", "mode",
      "visible", "with colour", "covered", "moving", "holes", "floaters", "wrong", "person",
      "flicker", "upload", "draw", "points=1");
  const auto quality = [](double psnr, double ssim) {
    return fmt::format("{:.2f} / {:.3f}", psnr, ssim);
  };
  const auto person = [](const ViewScore& s) -> std::string {
    if (std::isnan(s.silhouette_missing)) return "-";
    return fmt::format("{:.1f}+{:.1f}%", 100 * s.silhouette_missing, 100 * s.silhouette_doubled);
  };
  for (const RenderRow& row : report.rows) {
    const ViewScore& s = row.score;
    out << fmt::format(
        "{:<8} {:>13} {:>13} {:>13} {:>7} {:>6.2f}% {:>7.2f}% {:>6.2f}% {:>12} {:>8.2f} "
        "{:>6.1f} ms {:>5.0f} ms {:>8}\n",
        row.mode, quality(s.psnr_visible, s.ssim_visible), quality(s.psnr_colored, s.ssim_colored),
        quality(s.psnr_covered, s.ssim_covered),
        std::isnan(s.psnr_moving) ? "-" : fmt::format("{:.2f}", s.psnr_moving), 100 * s.holes,
        100 * s.floaters, 100 * s.wrong_depth, person(s), row.flicker_levels, row.upload_cpu_ms,
        row.draw_cpu_ms, fmt::format("{:.2f}", cost_vs_points(row)));
  }
  out << "person: of the silhouettes of people, what is missing + what is drawn twice\n";
  print_stereo(report, out);
}

void print_json(const RenderReport& report, std::ostream& out) {
  nlohmann::json json = {{"rig", report.rig},
                         {"driver", report.driver},
                         {"sensors", report.sensors},
                         {"views", report.views},
                         {"width", report.width},
                         {"height", report.height},
                         {"rows", nlohmann::json::array()}};
  for (const RenderRow& row : report.rows) {
    const ViewScore& s = row.score;
    json["rows"].push_back({{"mode", row.mode},
                            {"psnr_all", s.psnr_all},
                            {"ssim_all", s.ssim_all},
                            {"psnr_visible", s.psnr_visible},
                            {"ssim_visible", s.ssim_visible},
                            {"psnr_colored", s.psnr_colored},
                            {"ssim_colored", s.ssim_colored},
                            {"psnr_covered", s.psnr_covered},
                            {"ssim_covered", s.ssim_covered},
                            {"psnr_moving", s.psnr_moving},
                            {"holes_visible", s.holes},
                            {"floaters", s.floaters},
                            {"wrong_depth", s.wrong_depth},
                            {"covered", s.covered},
                            {"silhouette_missing", s.silhouette_missing},
                            {"silhouette_doubled", s.silhouette_doubled},
                            {"flicker_levels", row.flicker_levels},
                            {"upload_cpu_ms", row.upload_cpu_ms},
                            {"draw_cpu_ms", row.draw_cpu_ms},
                            {"cost_vs_points", cost_vs_points(row)}});
    if (row.stereo.one_by_one_cpu_ms == 0) continue;
    json["rows"].back()["stereo"] = {{"at_once_cpu_ms", row.stereo.at_once_cpu_ms},
                                     {"one_by_one_cpu_ms", row.stereo.one_by_one_cpu_ms},
                                     {"at_once_vs_one_by_one", stereo_vs_two(row)}};
  }
  out << json.dump(1) << "\n";
}

}  // namespace roomcast::bench
