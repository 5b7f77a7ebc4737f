// SPDX-License-Identifier: Apache-2.0
// Options of `roomcast export --format video`.
#pragma once

#include <filesystem>
#include <vector>

#include <CLI/CLI.hpp>

#include "roomcast/core/result.h"
#include "roomcast/recording/film/film_writer.h"

namespace roomcast::cli {

struct FilmCommandOptions {
  std::filesystem::path path;
  std::vector<int> size = {1280, 720};
  int fps = 30;
  double fov_deg = 60;
  render::RenderMode mode = render::RenderMode::kBlend;
  bool silent = false;

  /// Options for a film of `length_s` seconds. Errors as for read_camera_path.
  [[nodiscard]] Result<recording::FilmOptions> film(double length_s) const;
};

void add_film_options(CLI::App& command, FilmCommandOptions& options);

}  // namespace roomcast::cli
