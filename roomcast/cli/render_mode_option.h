// SPDX-License-Identifier: Apache-2.0
// Options that name ways of drawing.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "roomcast/render/render_mode.h"

namespace roomcast::cli {

void add_mode_option(CLI::App& command, const std::string& name, render::RenderMode& mode);
/// Several, separated by commas.
void add_modes_option(CLI::App& command, const std::string& name, std::vector<render::RenderMode>& modes);

}  // namespace roomcast::cli
