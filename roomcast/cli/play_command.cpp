// SPDX-License-Identifier: Apache-2.0
// roomcast play: replays a recording as a room, on a hub of its own or on another hub.
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stderr_log.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/cli/token_option.h"
#include "roomcast/cli/web_directory.h"
#include "roomcast/hub/server/hub_server.h"
#include "roomcast/recording/recorder/room_player.h"
#include "roomcast/recording/room/room_recording.h"

namespace roomcast::cli {
namespace {

using namespace std::chrono_literals;

struct PlayOptions {
  std::string file;
  recording::RoomPlayerOptions player;
  TokenOption token;
  int port = 7600;
  std::string web;
  bool json = false;
  bool verbose = false;
};

/// A hub in this process. It stops when this object is destroyed.
class OwnHub {
 public:
  static Result<OwnHub> open(const PlayOptions& options, const std::string& room) {
    hub::HubOptions hub;
    hub.port = static_cast<std::uint16_t>(options.port);
    hub.rooms = {{.name = room.empty() ? "recording" : room}};
    hub.web_directory = find_web_directory(options.web);
    hub.log = stderr_log("play", options.verbose);
    auto server = hub::HubServer::open(std::move(hub));
    if (!server) return server.error();
    return OwnHub(std::move(*server));
  }
  [[nodiscard]] std::uint16_t port() const { return server_->port(); }

 private:
  explicit OwnHub(std::unique_ptr<hub::HubServer> server)
      : server_(std::move(server)),
        thread_([hub = server_.get()](const std::stop_token& end) { hub->run(end); }) {}

  std::unique_ptr<hub::HubServer> server_;
  std::jthread thread_;
};

double seconds_of(const recording::RoomRecording& recording) {
  return std::chrono::duration<double>(recording.end() - recording.start()).count();
}

/// Shows the playback position until the player ends.
void show_progress(const recording::RoomPlayer& player, double length_s,
                   const std::stop_token& ended) {
  StatusLine line;
  while (!ended.stop_requested()) {
    std::this_thread::sleep_for(100ms);
    const recording::PlayProgress progress = player.progress();
    line.show(fmt::format("{:.1f} of {:.1f} s, {} frames   (Ctrl-C stops)", progress.position_s,
                          length_s, progress.frames_sent));
  }
}

Outcome run_play(PlayOptions options) {
  StopOnSignal stop;
  if (auto status = options.player.check(); !status) return status.error();
  const auto recording = recording::RoomRecording::open(options.file);
  if (!recording) return recording.error();
  if (recording->sensors().empty())
    return Error{ErrorCode::kNotFound, options.file + " has no frame of any sensor"};
  const LogSink log = stderr_log("play", options.verbose);
  if (recording->damage()) {
    log(LogLevel::kWarning, *recording->damage() + "; everything before it was played");
  }
  std::optional<OwnHub> own_hub;
  if (options.player.hub_url.empty()) {
    auto hub = OwnHub::open(options, recording->room());
    if (!hub) return hub.error();
    own_hub.emplace(std::move(*hub));
    options.player.hub_url = fmt::format("ws://127.0.0.1:{}", own_hub->port());
    if (options.json) {  // stdout is for the report
      print_err("roomcast play: open http://127.0.0.1:{}/\n", own_hub->port());
    } else {
      print_out("roomcast play: open http://127.0.0.1:{}/\n", own_hub->port());
      std::fflush(stdout);
    }
  }
  auto credential = find_credential(options.token);
  if (!credential) return credential.error();
  options.player.credential = *std::move(credential);
  options.player.log = log;
  auto player = recording::RoomPlayer::open(*recording, options.player);
  if (!player) return player.error();
  std::jthread shown([&](const std::stop_token& ended) {
    show_progress(**player, seconds_of(*recording), ended);
  });
  const Status status = (*player)->run(stop.token());
  shown.request_stop();
  shown.join();
  if (options.json) {
    const recording::PlayProgress progress = (*player)->progress();
    nlohmann::json json = {{"frames_sent", progress.frames_sent},
                           {"position_s", progress.position_s}};
    add_error(status, json);
    print_out("{}\n", json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  return {status, true};
}

}  // namespace

void add_play_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<PlayOptions>();
  CLI::App* command = app.add_subcommand("play", "Play a recording as a room");
  command->add_option("file", options->file, "FILE.mcap of roomcast record")->required();
  command->add_option("--hub", options->player.hub_url,
                      "Join this hub as the recorded sensors (default: a hub of its own)");
  command->add_option("--room", options->player.room, "The room there");
  add_token_options(*command, options->token);
  command->add_option("--from", options->player.from_s, "Begin at this second")
      ->check(seconds_from_zero());
  command->add_option("--speed", options->player.speed, "Speed, 0.1 to 10; 2 is twice as fast")
      ->capture_default_str();
  command->add_flag("--loop", options->player.loop, "Start again at the end");
  command->add_option("--port", options->port, "Port of its own hub; 0 takes any free one")
      ->check(within(0, 65'535))
      ->capture_default_str();
  command->add_option("--web", options->web,
                      "Folder of the built page (default: the one beside this program)");
  command->add_flag("--json", options->json,
                    "Print JSON at the end: the numbers of frames and bytes sent");
  command->add_flag("--verbose", options->verbose, "Log joins and leaves");
  command->footer(
      "Frames are sent as they were recorded, bit for bit. A new viewer sees a sensor from its "
      "next\n"
      "key frame on. To encode them anew: roomcast sensor --source mcap:FILE#s0.\n"
      "Example:\n"
      "  roomcast play lab.mcap --loop");
  command->callback(
      [options, &chosen] { chosen = [options] { return finish("play", run_play(*options)); }; });
}

}  // namespace roomcast::cli
