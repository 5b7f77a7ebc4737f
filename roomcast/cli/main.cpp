// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <cstdio>
#include <string>

#include <fmt/format.h>

#include "roomcast/cli/command.h"

namespace {

using namespace roomcast::cli;

/// Finds the unknown word. CLI11 only reports that a command is missing.
std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  const std::string word = argv[1];
  const auto known =
      app.get_subcommands([&](const CLI::App* command) { return command->get_name() == word; });
  return known.empty() ? word : "";
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("roomcast: be in a room that is somewhere else.", "roomcast");
  app.set_version_flag("--version", ROOMCAST_VERSION);
  app.require_subcommand(1);
  app.footer("Example: roomcast demo");
  Command chosen;
  add_demo_command(app, chosen);
  add_hub_command(app, chosen);
  add_sensor_command(app, chosen);
  add_view_command(app, chosen);
  add_simulate_command(app, chosen);
  add_contact_sheet_command(app, chosen);
  add_calibrate_command(app, chosen);
  add_devices_command(app, chosen);
  add_record_command(app, chosen);
  add_play_command(app, chosen);
  add_info_command(app, chosen);
  add_export_command(app, chosen);
  add_measure_command(app, chosen);
  add_align_command(app, chosen);
  add_board_command(app, chosen);
  add_nudge_command(app, chosen);
  add_token_command(app, chosen);
  add_bench_command(app, chosen);
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

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // writing to a closed socket or pipe must fail with an error
                                  // code, not kill the process
  return parse_and_run(argc, argv);
}
