// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/program.h"

#include <csignal>
#include <cstdio>
#include <string>

#include <fmt/format.h>

namespace roomcast::cli {
namespace {

/// CLI11 only says that a command is missing, not which word it did not know.
std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  const std::string word = argv[1];
  const auto known =
      app.get_subcommands([&](const CLI::App* command) { return command->get_name() == word; });
  return known.empty() ? word : "";
}

}  // namespace

int run_program(int argc, char** argv, std::span<const AddCommand> commands) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed socket or pipe is an error code to us, not an end
  CLI::App app("roomcast: walk around live in a remote room.", "roomcast");
  app.set_version_flag("--version", ROOMCAST_VERSION);
  app.require_subcommand(1);
  app.footer("Example: roomcast demo");
  Command chosen;
  for (const AddCommand add : commands) add(app, chosen);
  if (const auto word = unknown_command(app, argc, argv); !word.empty()) {
    fmt::print(stderr, "roomcast: there is no command \"{}\" (roomcast --help lists them)\n", word);
    return kWrongUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "roomcast: {} (roomcast --help shows how)\n", error.what());
    return kWrongUsage;
  }
  return chosen();
}

}  // namespace roomcast::cli
