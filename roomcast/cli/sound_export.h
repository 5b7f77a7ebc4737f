// SPDX-License-Identifier: Apache-2.0
// The wav format of roomcast export: what people say in a recording.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/core/clock.h"
#include "roomcast/recording/film/film_writer.h"

namespace roomcast::cli {

struct SoundOptions {
  bool per_person = false;
  std::vector<double> listen;  // x,y,z of the listener, x,y,z of what they look at; empty: mono
  nanoseconds from{}, to{};    // 0: to the end
};

void add_sound_options(CLI::App& command, SoundOptions& options);

/// Adds what people say in the recording to OUT/film.mp4, as heard from the camera. Where that is
/// not possible the film stays silent, and a line says why; nothing is said where there are no
/// voices.
void give_film_voices(const std::string& recording, const std::filesystem::path& out,
                      const recording::FilmWriter& film, const std::stop_token& stop);

/// Also prints what was written.
[[nodiscard]] Outcome export_sound(const std::string& recording, const std::filesystem::path& out,
                                   const SoundOptions& options, bool json,
                                   const std::stop_token& stop);

}  // namespace roomcast::cli
