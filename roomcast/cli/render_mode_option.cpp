// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/render_mode_option.h"

#include <map>

namespace roomcast::cli {
namespace {

std::map<std::string, RenderMode> modes_by_name() {
  std::map<std::string, RenderMode> modes;
  for (const RenderMode mode : kRenderModes) modes.emplace(name_of(mode), mode);
  return modes;
}

std::string all_names() {
  std::string names;
  for (const RenderMode mode : kRenderModes) {
    names += (names.empty() ? "" : ", ") + std::string(name_of(mode));
  }
  return names;
}

}  // namespace

void add_mode_option(CLI::App& command, const std::string& name, RenderMode& mode) {
  command.add_option(name, mode, "How surfaces are drawn: " + all_names())
      ->transform(CLI::CheckedTransformer(modes_by_name()));
}

void add_modes_option(CLI::App& command, const std::string& name, std::vector<RenderMode>& modes) {
  command.add_option(name, modes, "How surfaces are drawn: of " + all_names() + "; all")
      ->delimiter(',')
      ->transform(CLI::CheckedTransformer(modes_by_name()));
}

}  // namespace roomcast::cli
