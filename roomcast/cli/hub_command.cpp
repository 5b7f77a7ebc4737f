// SPDX-License-Identifier: Apache-2.0
// roomcast hub: joins sensors and viewers, one room, one port.
#include <cstdio>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "roomcast/cli/command.h"
#include "roomcast/cli/listen_address.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/cli/web_directory.h"
#include "roomcast/hub/hub_server.h"

namespace roomcast::cli {
namespace {

struct HubCommandOptions {
  std::string listen = "127.0.0.1:7600";
  std::string room = "room";
  std::string web;
  bool insecure = false;
  bool verbose = false;
};

Status run_hub(const HubCommandOptions& options) {
  StopOnSignal stop;
  const auto listen = parse_listen_address(options.listen);
  if (!listen) return listen.error();
  if (!listen->loopback && !options.insecure) {
    return Error{ErrorCode::kInvalidArgument,
                 "without TLS a hub listens on this machine only: use 127.0.0.1, or say --insecure "
                 "if you trust everyone "
                 "on the network"};
  }
  hub::HubOptions hub;
  hub.address = listen->address;
  hub.port = listen->port;
  hub.room = options.room;
  hub.web_directory = find_web_directory(options.web);
  hub.log = stderr_log("hub", options.verbose);
  auto server = hub::HubServer::open(std::move(hub));
  if (!server) return server.error();
  const bool v6 = listen->address.find(':') != std::string::npos;
  fmt::print("roomcast hub: open http://{}{}{}:{}/\n", v6 ? "[" : "", listen->address,
             v6 ? "]" : "", (*server)->port());
  std::fflush(stdout);
  (*server)->run(stop.token());
  return {};
}

}  // namespace

void add_hub_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<HubCommandOptions>();
  CLI::App* command =
      app.add_subcommand("hub", "Join sensors and viewers in a room, and serve the page");
  command->add_option("--listen", options->listen, "ADDRESS:PORT; port 0 takes any free one")
      ->capture_default_str();
  command->add_option("--room", options->room, "The room's name")->capture_default_str();
  command->add_option("--web", options->web,
                      "Folder of the built page (default: the one beside this program)");
  command->add_flag("--insecure", options->insecure,
                    "Listen beyond this machine although nothing is encrypted");
  command->add_flag("--verbose", options->verbose, "Say who joins and leaves");
  command->footer(
      "Example:\n  roomcast hub --listen 127.0.0.1:7600\nThen open http://127.0.0.1:7600/ and "
      "start sensors.");
  command->callback(
      [options, &chosen] { chosen = [options] { return finish("hub", run_hub(*options)); }; });
}

}  // namespace roomcast::cli
