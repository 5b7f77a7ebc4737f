// SPDX-License-Identifier: Apache-2.0
// roomcast foxglove: serves a room to Foxglove and its kin, live.
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <boost/asio/ip/address.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/hub_option.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/stderr_log.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/cli/token_option.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/foxglove/room_bridge.h"

namespace roomcast::cli {
namespace {

struct FoxgloveOptions {
  client::SubscriberOptions subscriber;
  TokenOption token;
  foxglove::FoxgloveServerOptions server;
  foxglove::RoomBridgeOptions bridge;
  std::vector<std::string> origins;
  int port = 8765;
  std::string up = "z";
  bool insecure = false;
  bool json = false;
  bool verbose = false;
};

Status check_address(const FoxgloveOptions& options) {
  boost::system::error_code error;
  const auto address = boost::asio::ip::make_address(options.server.address, error);
  if (error)
    return invalid_argument("--address is a numeric address, such as 127.0.0.1 or 0.0.0.0");
  if (address.is_loopback() || options.insecure) return {};
  return invalid_argument(
      "everybody who reaches " + options.server.address +
      " could watch the room: this protocol has no tokens and is not encrypted here; --insecure "
      "allows it, ssh -L 8765:127.0.0.1:8765 is an alternative");
}

void announce(const FoxgloveOptions& options, std::uint16_t port) {
  const std::string& address = options.server.address;
  const std::string host = address.find(':') == std::string::npos ? address : "[" + address + "]";
  const std::string url = fmt::format("ws://{}:{}", host, port);
  if (options.json) {
    print_out("{}\n", nlohmann::json{{"url", url}}.dump());
  } else {
    print_out("roomcast foxglove: open {} in Foxglove (Foxglove WebSocket)\n", url);
  }
  std::fflush(stdout);
}

Status run_foxglove(FoxgloveOptions options) {
  StopOnSignal stop;
  if (auto status = check_address(options); !status) return status;
  if (auto status = options.bridge.topics.cloud.check(); !status) return status;
  auto credential = find_credential(options.token);
  if (!credential) return credential.error();
  const LogSink log = stderr_log("foxglove", options.verbose);
  options.subscriber.credential = *std::move(credential);
  options.subscriber.log = log;
  options.subscriber.stop = stop.token();
  options.bridge.topics.up = options.up == "y" ? recording::UpAxis::kY : recording::UpAxis::kZ;
  options.bridge.log = log;
  options.server.port = static_cast<std::uint16_t>(options.port);
  options.server.log = log;
  options.server.origins.insert(options.server.origins.end(), options.origins.begin(),
                                options.origins.end());
  const auto room = client::Subscriber::open(options.subscriber);
  if (!room) return room.error();
  const std::string name = (*room)->snapshot()->room;
  options.server.name = name.empty() ? "roomcast" : "roomcast: " + name;
  const auto server = foxglove::FoxgloveServer::listen(options.server);
  if (!server) return server.error();
  announce(options, (*server)->port());
  return foxglove::bridge_room(**room, **server, options.bridge, stop.token());
}

}  // namespace

void add_foxglove_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<FoxgloveOptions>();
  CLI::App* command =
      app.add_subcommand("foxglove", "Serve a room to Foxglove and Lichtblick, live");
  add_hub_option(*command, options->subscriber.hub_url);
  command->add_option("--room", options->subscriber.room, "The room (default: the hub's only one)");
  add_token_options(*command, options->token);
  command->add_option("--port", options->port, "Port to serve on; 0 takes any free one")
      ->check(within(0, 65'535))
      ->capture_default_str();
  command
      ->add_option("--address", options->server.address,
                   "Numeric address to serve on; others than this computer's need --insecure")
      ->capture_default_str();
  command->add_flag("--insecure", options->insecure,
                    "Allow everybody who reaches --address to watch, without encryption");
  command->add_option("--origin", options->origins,
                      "Site whose pages may connect, https://HOST; may be given several times");
  command->add_option("--up", options->up, "Axis of `world` that points up: z or y")
      ->check(CLI::IsMember({"y", "z"}))
      ->capture_default_str();
  command
      ->add_option("--voxel", options->bridge.topics.cloud.voxel_m,
                   "One point of the cloud for each cube of this size (metres)")
      ->check(within(0.0, 1.0));
  command->add_flag("--json", options->json, "Print the address as JSON");
  command->add_flag("--verbose", options->verbose, "Log the connection's state");
  command->footer(
      "Topics: /points, /tf, and for each sensor /NAME/color, /NAME/depth, /NAME/camera. Only what "
      "a\n"
      "client subscribes to is sent; one that reads slowly gets fewer and newer messages.\n"
      "Example:\n  roomcast foxglove --hub ws://127.0.0.1:7600 --port 8765");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("foxglove", run_foxglove(*options)); };
  });
}

}  // namespace roomcast::cli
