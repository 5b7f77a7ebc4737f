// SPDX-License-Identifier: Apache-2.0
// The program around its commands: parses the command line and runs the command that was chosen.
#pragma once

#include <span>
#include <string>

#include "roomcast/cli/command.h"

namespace roomcast::cli {

/// Adds one command to the command line, as those of command.h do.
using AddCommand = void (*)(CLI::App& app, Command& chosen);

/// The body of main(); returns the exit code. `version`: what --version says.
int run_program(int argc, char** argv, std::span<const AddCommand> commands,
                const std::string& version);

}  // namespace roomcast::cli
