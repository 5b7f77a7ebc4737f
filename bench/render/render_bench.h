// SPDX-License-Identifier: Apache-2.0
// `roomcast bench render`: image quality from viewpoints without a sensor, for every render mode,
// on a rig with true views; and the cost of drawing relative to points of one pixel (the paper's
// method) in the same run and on the same driver. Frames are registered but not encoded. The
// renderer's background model has seen all frames of the recording except the compared ones. People
// are judged by their silhouettes, too (silhouette.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "bench/render/drawing_cost.h"
#include "bench/render/view_score.h"
#include "roomcast/core/result.h"
#include "roomcast/render/room_renderer.h"

namespace roomcast::bench {

struct RenderBenchOptions {
  std::filesystem::path rig;
  std::vector<render::RenderMode> modes = {};         // empty: all
  std::optional<std::filesystem::path> aligned = {};  // for read_aligned_poses; else rig poses
  int color_scale = 1;                                // as in RegistrationOptions
  /// Every sensor is moved and rotated by this much, each in a different direction.
  double pose_error_mm = 0, pose_error_deg = 0;
  std::uint64_t pose_seed = 1;
  double late_ms = 0;       // > 0: of the rig's last sensor pictures this old are shown,
  bool keep_late = false;   // whole, instead of as RoomRenderer::set_late does
  bool one_instant = true;  // draws what moves where it is at the instant of the truth
  bool fill_holes = true;   // as a sensor does; false: as recorded
  /// Where no sensor shows anything, the blend shows the model of what stands still.
  bool model = false;
  bool stereo = false;                                 // also measures the cost of two eyes
  std::optional<std::filesystem::path> pictures = {};  // a folder for the drawn pictures
};

struct RenderRow {
  std::string mode;
  ViewScore score;            // mean over the views
  double flicker_levels = 0;  // of static surfaces between consecutive frames
  double upload_cpu_ms = 0;   // per sensor frame: upload and work done once per frame
  /// Per view, all threads of the process (a software driver draws there): for this mode, and for
  /// points, which are drawn in turns with it so that other load slows both.
  double draw_cpu_ms = 0, points_cpu_ms = 0;
  StereoCost stereo;  // per view, if requested
};

struct RenderReport {
  std::string rig, driver;
  int sensors = 0, views = 0;
  int width = 0, height = 0;
  std::vector<RenderRow> rows;
};

/// Makes its own GL context. kUnavailable: no driver. Errors of the files.
[[nodiscard]] Result<RenderReport> run_render_bench(
    const RenderBenchOptions& options, const std::function<void(const std::string&)>& progress);

void print_table(const RenderReport& report, std::ostream& out);
/// One JSON object: the fields of the report and its rows, by name.
void print_json(const RenderReport& report, std::ostream& out);

}  // namespace roomcast::bench
