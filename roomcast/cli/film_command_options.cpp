// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/film_command_options.h"

#include <numbers>

#include "roomcast/cli/number_option.h"
#include "roomcast/cli/render_mode_option.h"

namespace roomcast::cli {

Result<recording::FilmOptions> FilmCommandOptions::film(double length_s) const {
  recording::FilmOptions film;
  film.size = {size[0], size[1]};
  film.fps = fps;
  film.vertical_fov_rad = fov_deg * std::numbers::pi / 180;
  film.mode = mode;
  film.length_s = length_s;
  if (path.empty()) return film;
  auto read = recording::read_camera_path(path);
  if (!read) return read.error();
  film.path = *std::move(read);
  return film;
}

void add_film_options(CLI::App& command, FilmCommandOptions& options) {
  command.add_option("--path", options.path,
                     "Video: the camera's path, a JSON file (default: a slow swing)");
  command.add_option("--size", options.size, "Video: width,height")
      ->delimiter(',')
      ->expected(2)
      ->capture_default_str();
  command.add_option("--fps", options.fps, "Video: pictures per second")
      ->check(within(1, 120))
      ->capture_default_str();
  command.add_option("--fov", options.fov_deg, "Video: vertical field of view, degrees")
      ->check(within(1.0, 170.0))
      ->capture_default_str();
  add_mode_option(command, "--mode", options.mode);
  command.add_flag("--silent", options.silent, "Video: leave out the people's voices");
}

}  // namespace roomcast::cli
