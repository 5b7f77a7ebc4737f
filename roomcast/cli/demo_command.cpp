// SPDX-License-Identifier: Apache-2.0
// roomcast demo: a hub, its sensors and the page in one process, over real loopback connections.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "roomcast/cli/clock_option.h"
#include "roomcast/cli/codec_option.h"
#include "roomcast/cli/command.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stderr_log.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/cli/web_directory.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/hub/daemon/data_folder.h"
#include "roomcast/hub/daemon/hub_aligners.h"
#include "roomcast/hub/daemon/hub_models.h"
#include "roomcast/hub/daemon/hub_recorders.h"
#include "roomcast/hub/server/hub_server.h"
#include "roomcast/recording/dataset/recording.h"
#include "roomcast/sensor/sensor_feed.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::cli {
namespace {

using namespace std::chrono_literals;
using Feeds = std::vector<std::unique_ptr<sensor::SensorFeed>>;
using Source = std::unique_ptr<source::FrameSource>;

struct DemoOptions {
  int sensors = 3;
  std::string scene;
  std::string rig;
  std::vector<std::string> sources;
  recording::JoiningClock clock = recording::JoiningClock::kAutomatic;
  double sim_fps = 15;
  sensor::CodecChoice codec;
  int port = 7600;
  std::string web;
  bool headless = false;
  double seconds = 0;
  bool true_poses = false;
  std::string recordings;
  bool admin_link = false;
  bool verbose = false;
};

/// The sources named by the options, one per sensor.
Result<std::vector<std::string>> source_specs(const DemoOptions& options) {
  std::vector<std::string> specs = options.sources;
  if (!options.rig.empty()) {
    auto names = recording::rig_sensor_names(options.rig);
    if (!names) return names.error();
    for (const auto& name : *names) specs.push_back("rig:" + options.rig + "#" + name);
  }
  if (!specs.empty()) return specs;
  for (int i = 0; i < options.sensors; ++i) {
    specs.push_back((options.scene.empty() ? "sim" : "sim:" + options.scene) + "#" +
                    std::to_string(i));
  }
  return specs;
}

void tell_of_recordings(const sensor::RecordedRoom& room) {
  for (const std::string& note : room.notes) print_err("roomcast demo: {}\n", note);
  if (!room.clock.empty())
    print_err("roomcast demo: the recordings are joined by {}\n", room.clock);
}

Result<Feeds> start_feeds(const DemoOptions& options, const std::vector<std::string>& specs,
                          std::uint16_t port, const std::stop_token& stop) {
  StatusLine line;
  Feeds feeds;
  sensor::SourceOptions source_options;
  source_options.sim_fps = options.sim_fps;
  source_options.sim_sensor_count = options.sensors;
  source_options.stop = stop;
  auto recorded = sensor::open_recorded_room(specs, source_options, options.clock);
  if (!recorded) return recorded.error();
  tell_of_recordings(*recorded);
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const std::string& spec = specs[i];
    if (stop.stop_requested()) break;
    line.show(fmt::format("starting sensor {} of {}: {}", i + 1, specs.size(), spec));
    Source source = std::move(recorded->sources[i]);
    if (!source) {
      auto opened = sensor::open_source(spec, source_options);
      if (!opened && stop.stop_requested()) break;
      if (!opened) return opened.error();
      source = *std::move(opened);
    }
    sensor::SensorFeedOptions feed_options;
    feed_options.hub_url = fmt::format("ws://127.0.0.1:{}", port);
    feed_options.codec = options.codec;
    feed_options.send_pose = options.true_poses || !spec.starts_with("sim");
    feed_options.log = stderr_log("demo", options.verbose);
    auto feed = sensor::SensorFeed::start(std::move(source), std::move(feed_options));
    if (!feed) return feed.error();
    feeds.push_back(std::move(*feed));
  }
  return feeds;
}

struct Totals {
  std::uint64_t frames = 0;
  std::uint64_t bytes = 0;
  bool is_watched = false;
};

Totals totals_of(const Feeds& feeds) {
  Totals totals;
  for (const auto& feed : feeds) {
    const sensor::SensorFeedStats stats = feed->stats();
    totals.frames += stats.frames_sent;
    totals.bytes += stats.bytes_sent;
    totals.is_watched |= stats.is_watched;
  }
  return totals;
}

Status first_failure(const Feeds& feeds) {
  for (const auto& feed : feeds) {
    if (auto result = feed->result(); result && !*result) return *result;
  }
  return {};
}

/// Runs until a stop request, until `seconds` have passed (0: no limit), or until a sensor fails.
Status show_room(const Feeds& feeds, double seconds, const std::stop_token& stop) {
  StatusLine line;
  Totals before;
  const auto begin = std::chrono::steady_clock::now();
  for (int tenths = 1; !stop.stop_requested(); ++tenths) {
    std::this_thread::sleep_for(100ms);
    if (auto failure = first_failure(feeds); !failure) return failure;
    if (seconds > 0 &&
        std::chrono::steady_clock::now() - begin > std::chrono::duration<double>(seconds))
      break;
    if (tenths % 10 != 0) continue;
    const Totals now = totals_of(feeds);
    line.show(fmt::format(
        "{} sensors, {:.1f} frames/s each, {:.2f} MB/s in all{}   (Ctrl-C stops)", feeds.size(),
        static_cast<double>(now.frames - before.frames) / static_cast<double>(feeds.size()),
        static_cast<double>(now.bytes - before.bytes) / 1e6,
        now.is_watched ? "" : ", nobody watches"));
    before = now;
  }
  return {};
}

/// Without a browser: a viewer in this process receives the room and reports what arrived.
Status watch_room(const Feeds& feeds, std::uint16_t port, double seconds,
                  const std::stop_token& stop) {
  auto viewer = client::Subscriber::open(
      {.hub_url = fmt::format("ws://127.0.0.1:{}", port), .room = {}, .name = "demo", .log = {}});
  if (!viewer) return viewer.error();
  const auto begin = std::chrono::steady_clock::now();
  if (auto status = show_room(feeds, seconds > 0 ? seconds : 10, stop); !status) return status;
  const auto room = (*viewer)->snapshot();
  const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::size_t seen = 0, placed = 0;
  for (const auto& sensor : room->sensors) {
    seen += sensor.picture != nullptr;
    placed += sensor.pose.is_placed() ? 1 : 0;
  }
  print_out("received {} of {} sensors, {} placed, {:.1f} frame sets/s, {:.2f} MB/s\n", seen,
            feeds.size(), placed, static_cast<double>(room->sets_received) / elapsed,
            static_cast<double>(room->bytes_received) / elapsed / 1e6);
  if (seen == feeds.size()) return {};
  return Error{ErrorCode::kUnavailable, "not every sensor sent a picture in time"};
}

/// Recorders for the page's console; null where there is neither a folder nor a home.
std::shared_ptr<hub::daemon::HubRecorders> make_recorders(const hub::daemon::OwnHub& own,
                                                          const DemoOptions& options,
                                                          const LogSink& log) {
  std::filesystem::path folder = options.recordings;
  if (folder.empty()) {
    const auto data = hub::daemon::default_data_folder();
    if (!data) return nullptr;
    folder = *data / "recordings";
  }
  return std::make_shared<hub::daemon::HubRecorders>(own, std::move(folder), log);
}

/// The address of the page, for a person to open. An admin's link has a one-time code: it is no
/// use in the history of a browser.
void print_address(const DemoOptions& options, const hub::HubServer& hub) {
  print_out("roomcast demo: open http://127.0.0.1:{}/{}\n", hub.port(), hub.link_fragment());
  if (options.admin_link) {
    print_out(
        "roomcast demo: the address works once, within an hour; its page makes further ones\n");
  }
  std::fflush(stdout);
}

Status run_demo(const DemoOptions& options) {
  StopOnSignal stop;
  const auto specs = source_specs(options);
  if (!specs) return specs.error();

  hub::HubOptions hub_options;
  hub_options.port = static_cast<std::uint16_t>(options.port);
  hub_options.rooms = {{.name = options.rig.empty() ? "demo" : "recording"}};
  hub_options.web_directory = find_web_directory(options.web);
  hub_options.log = stderr_log("demo", options.verbose);
  hub::daemon::OwnHub own;
  const auto models = std::make_shared<hub::daemon::HubModels>(own, std::nullopt, hub_options.log);
  hub_options.models = models;
  hub::daemon::HubAligners aligners(own, hub_options.log);
  hub_options.on_room_in_use = [&aligners, models](const std::string& room) {
    aligners.start(room);
    models->start(room);
  };
  const auto recorders = make_recorders(own, options, hub_options.log);
  hub_options.recordings = recorders;
  if (options.admin_link) {
    hub_options.first_link = {.room = std::string(hub::kAllRooms), .role = hub::TokenRole::kAdmin};
  }
  auto hub = hub::HubServer::open(std::move(hub_options));
  if (!hub) return hub.error();
  own.opened({.port = (*hub)->port()}, (*hub)->own_token());
  models->start_kept();
  const std::jthread hub_thread([&hub](const std::stop_token& end) { (*hub)->run(end); });

  auto feeds = start_feeds(options, *specs, (*hub)->port(), stop.token());
  if (!feeds) return feeds.error();
  if (stop.token().stop_requested()) return {};
  print_address(options, **hub);
  return options.headless ? watch_room(*feeds, (*hub)->port(), options.seconds, stop.token())
                          : show_room(*feeds, options.seconds, stop.token());
}

}  // namespace

void add_demo_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<DemoOptions>();
  CLI::App* command =
      app.add_subcommand("demo", "Hub, sensors and page in one: open the address it prints");
  command->add_option("--sensors", options->sensors, "Simulated sensors")
      ->check(within(1, 8))
      ->capture_default_str();
  command->add_option("--scene", options->scene, "Simulated scene");
  command->add_option("--fps", options->sim_fps, "Frames per second of simulated sensors")
      ->check(within(1.0, 60.0))
      ->capture_default_str();
  add_codec_options(*command, options->codec);
  command->add_option("--rig", options->rig, "Play this recorded rig instead");
  command->add_option(
      "--source", options->sources,
      "Play these sources instead, as one room: mkv:FILE, bag:FILE, rig:DIR#s0, tum:DIR, "
      "sim[:scene][#n]");
  add_clock_option(*command, options->clock);
  command->add_option("--port", options->port, "Port of page and hub; 0 takes any free one")
      ->check(within(0, 65'535))
      ->capture_default_str();
  command->add_option("--web", options->web,
                      "Folder of the built page (default: the one beside this program)");
  command->add_flag(
      "--headless", options->headless,
      "No browser: receive the room in this process and report (10 s unless --seconds)");
  command->add_option("--seconds", options->seconds, "Stop after this time")
      ->check(seconds_from_zero());
  command->add_flag("--true-poses", options->true_poses,
                    "Take the poses of simulated sensors from the simulator instead of aligning");
  command->add_flag("--admin-link", options->admin_link,
                    "Print an address with an admin's one-time code: whoever opens it may record "
                    "and place sensors by hand");
  command->add_option("--recordings", options->recordings,
                      "Folder for recordings by admins (default: "
                      "~/.local/state/roomcast/recordings)");
  command->add_flag("--verbose", options->verbose, "Log joins and leaves");
  command->footer(
      "Examples:\n  roomcast demo\n  roomcast demo --rig recordings/lab\n"
      "  roomcast demo --source mkv:left.mkv --source mkv:right.mkv");
  command->callback(
      [options, &chosen] { chosen = [options] { return finish("demo", run_demo(*options)); }; });
}

}  // namespace roomcast::cli
