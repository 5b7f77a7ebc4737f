// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/render_mode_option.h"

#include <map>

#include "roomcast/cli/named_choice.h"

namespace roomcast::cli {
namespace {

std::map<std::string, render::RenderMode> modes_by_name() {
  std::map<std::string, render::RenderMode> modes;
  for (const render::RenderMode mode : render::kRenderModes) modes.emplace(name_of(mode), mode);
  return modes;
}

}  // namespace

void add_mode_option(CLI::App& command, const std::string& name, render::RenderMode& mode) {
  choose_by_name(command.add_option(name, mode, "How surfaces are drawn"), modes_by_name());
}

void add_modes_option(CLI::App& command, const std::string& name,
                      std::vector<render::RenderMode>& modes) {
  choose_by_name(
      command.add_option(name, modes, "Ways to draw surfaces (default: all)")->delimiter(','),
      modes_by_name());
}

}  // namespace roomcast::cli
