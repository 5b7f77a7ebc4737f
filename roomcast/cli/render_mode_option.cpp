// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/render_mode_option.h"

#include <map>

#include "roomcast/cli/named_choice.h"

namespace roomcast::cli {
namespace {

std::map<std::string, RenderMode> modes_by_name() {
  std::map<std::string, RenderMode> modes;
  for (const RenderMode mode : kRenderModes) modes.emplace(name_of(mode), mode);
  return modes;
}

}  // namespace

void add_mode_option(CLI::App& command, const std::string& name, RenderMode& mode) {
  choose_by_name(command.add_option(name, mode, "How surfaces are drawn"), modes_by_name());
}

void add_modes_option(CLI::App& command, const std::string& name, std::vector<RenderMode>& modes) {
  choose_by_name(command.add_option(name, modes, "How surfaces are drawn; all")->delimiter(','),
                 modes_by_name());
}

}  // namespace roomcast::cli
