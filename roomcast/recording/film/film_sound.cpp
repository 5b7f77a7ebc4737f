// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/film/film_sound.h"

#include <string>
#include <vector>

#include <sys/wait.h>

#include "roomcast/core/child_program.h"

namespace roomcast::recording {

Status add_sound(const std::filesystem::path& film, const std::filesystem::path& sound) {
  std::filesystem::path part = film;
  part.replace_extension(".part.mp4");
  const std::vector<std::string> command = {
      "ffmpeg", "-loglevel",    "error", "-nostdin", "-y",   "-i",         film.string(),
      "-i",     sound.string(), "-map",  "0:v",      "-map", "1:a",        "-c:v",
      "copy",   "-c:a",         "aac",   "-b:a",     "128k", part.string()};
  const auto pid = start_program(command, {.shares_stderr = true});
  if (!pid) return pid.error();
  const int state = wait_for_program(*pid);
  std::error_code error;
  if (WIFEXITED(state) && WEXITSTATUS(state) == 0) {
    std::filesystem::rename(part, film, error);
    if (!error) return {};
  }
  std::filesystem::remove(part, error);
  return Error{ErrorCode::kUnavailable, "ffmpeg could not add the sound to " + film.string()};
}

}  // namespace roomcast::recording
