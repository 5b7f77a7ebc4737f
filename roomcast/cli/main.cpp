// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <cstdio>

#include <fmt/format.h>

#include "roomcast/cli/command.h"

namespace {

using namespace roomcast::cli;

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
  add_info_command(app, chosen);
  add_bench_command(app, chosen);
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
  std::signal(SIGPIPE, SIG_IGN);  // a closed socket or pipe is an error code to us, not an end
  return parse_and_run(argc, argv);
}
