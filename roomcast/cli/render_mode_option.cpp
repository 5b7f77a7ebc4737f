// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/render_mode_option.h"

#include <map>

#include "roomcast/cli/named_choice.h"

namespace roomcast::cli {
namespace {

template <std::size_t kCount>
std::map<std::string, render::RenderMode> by_name(
    const std::array<render::RenderMode, kCount>& modes) {
  std::map<std::string, render::RenderMode> named;
  for (const render::RenderMode mode : modes) named.emplace(name_of(mode), mode);
  return named;
}

}  // namespace

void add_mode_option(CLI::App& command, const std::string& name, render::RenderMode& mode) {
  choose_by_name(command.add_option(name, mode, "How surfaces are drawn"),
                 by_name(render::kRenderModes));
}

void add_view_mode_option(CLI::App& command, const std::string& name, render::RenderMode& mode) {
  choose_by_name(command.add_option(name, mode, "How the room is drawn"),
                 by_name(render::kViewModes));
}

void add_modes_option(CLI::App& command, const std::string& name,
                      std::vector<render::RenderMode>& modes) {
  choose_by_name(
      command.add_option(name, modes, "Ways to draw surfaces (default: all)")->delimiter(','),
      by_name(render::kRenderModes));
}

void add_view_modes_option(CLI::App& command, const std::string& name,
                           std::vector<render::RenderMode>& modes) {
  choose_by_name(command.add_option(name, modes, "Ways to draw the room (default: all but still)")
                     ->delimiter(','),
                 by_name(render::kViewModes));
}

}  // namespace roomcast::cli
