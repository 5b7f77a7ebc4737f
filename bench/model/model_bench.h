// SPDX-License-Identifier: Apache-2.0
// `roomcast bench model`: the fused model of simulated rigs next to the truth: errors, coverage of
// what was seen, memory, time and bytes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "bench/model/color_step.h"
#include "bench/model/model_score.h"
#include "roomcast/core/result.h"
#include "roomcast/model/model_options.h"

namespace roomcast::bench {

struct ModelBenchOptions {
  std::vector<std::filesystem::path> rigs;
  model::ModelOptions model;
  /// Instead of the rig's own fused mesh: the model of a running room that played this rig, as the
  /// hub has given it (docs/spec/model.md). For one rig.
  std::optional<std::filesystem::path> kept = {};
  bool compressed = false;                             // look at the mesh as room.draco.glb has it
  std::optional<std::filesystem::path> pictures = {};  // a folder for the pictures of add_score
};

struct ModelRow {
  std::string rig;
  std::size_t views = 0, frames = 0;
  ScoreFigures sensors;  // from the sensors' places
  ScoreFigures free;     // from places without a sensor
  std::size_t volume_bytes = 0, points = 0, triangles = 0;
  std::size_t file_bytes = 0;  // of room.draco.glb, without its few of JSON
  ColorSteps colors;
  double frame_cpu_ms = 0;  // to gather a frame, without reading it
  double fuse_cpu_s = 0;    // volume, mesh and colours, all threads
};

/// kNotFound: a rig has no truth. kInvalidArgument: `kept` with several rigs. Errors of the files
/// and of fuse_views.
[[nodiscard]] Result<std::vector<ModelRow>> run_model_bench(
    const ModelBenchOptions& options, const std::function<void(const std::string&)>& progress);

void print_table(const std::vector<ModelRow>& rows, std::ostream& out);
/// A JSON list: the fields of the rows, by name.
void print_json(const std::vector<ModelRow>& rows, std::ostream& out);

}  // namespace roomcast::bench
