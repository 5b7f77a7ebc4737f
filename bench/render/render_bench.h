// SPDX-License-Identifier: Apache-2.0
// `roomcast bench render`: how well a room is drawn from where no sensor stood, for every mode, on
// a rig that has true views; and what drawing costs beside points of one pixel (the paper's way) in
// the same run and on the same driver. Frames are registered, not sent through a codec. What the
// renderer remembers of the background it has seen in all frames of the recording but those that
// are compared.
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
  std::vector<render::RenderMode> modes = {};                 // empty: all
  std::optional<std::filesystem::path> aligned = {};  // read_aligned_poses; else the rig's own
  int color_scale = 1;                                // RegistrationOptions
  /// Every sensor is moved and turned by this much, each in a direction of its own.
  double pose_error_mm = 0, pose_error_deg = 0;
  std::uint64_t pose_seed = 1;
  bool stereo = false;                                 // what two eyes cost, too
  std::optional<std::filesystem::path> pictures = {};  // a folder to write what was drawn into
};

struct RenderRow {
  std::string mode;
  ViewScore score;            // mean over the views
  double flicker_levels = 0;  // of still surfaces from one frame to the next
  double upload_cpu_ms = 0;   // per sensor frame: upload, and what is derived from it once
  /// Per view, all threads of the process (a software driver draws there): of this mode, and of
  /// points, which are drawn in turns with it so that whatever else runs slows both.
  double draw_cpu_ms = 0, points_cpu_ms = 0;
  StereoCost stereo;  // per view, when it was asked for
};

struct RenderReport {
  std::string rig, driver;
  int sensors = 0, views = 0;
  int width = 0, height = 0;
  std::vector<RenderRow> rows;
};

/// Needs no GL context; makes one. kUnavailable without a driver; errors of the files.
[[nodiscard]] Result<RenderReport> run_render_bench(
    const RenderBenchOptions& options, const std::function<void(const std::string&)>& progress);

void print_table(const RenderReport& report, std::ostream& out);
/// One JSON object: the fields of the report and its rows, by name.
void print_json(const RenderReport& report, std::ostream& out);

}  // namespace roomcast::bench
