// SPDX-License-Identifier: Apache-2.0
// --hub of the commands that are a hub's clients.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace roomcast::cli {

/// Required.
inline void add_hub_option(CLI::App& command, std::string& hub_url) {
  command
      .add_option("--hub", hub_url,
                  "ws://HOST:PORT, or several with commas; when one is lost, the next is used")
      ->required();
}

}  // namespace roomcast::cli
