// SPDX-License-Identifier: Apache-2.0
// Options whose values are render modes.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "roomcast/render/render_mode.h"

namespace roomcast::cli {

void add_mode_option(CLI::App& command, const std::string& name, render::RenderMode& mode);
/// Also the mode that shows the room's model alone.
void add_view_mode_option(CLI::App& command, const std::string& name, render::RenderMode& mode);
/// Takes several modes, separated by commas.
void add_modes_option(CLI::App& command, const std::string& name,
                      std::vector<render::RenderMode>& modes);
/// As add_modes_option, also the mode that shows the room's model alone.
void add_view_modes_option(CLI::App& command, const std::string& name,
                           std::vector<render::RenderMode>& modes);

}  // namespace roomcast::cli
