// SPDX-License-Identifier: Apache-2.0
// roomcast sensor: streams one sensor's frames into a room, and a microphone's sound.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/codec_option.h"
#include "roomcast/cli/command.h"
#include "roomcast/cli/hub_option.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/sensor_camera_options.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stderr_log.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/cli/token_option.h"
#include "roomcast/sensor/remote_settings.h"
#include "roomcast/sensor/sensor_feed.h"
#include "roomcast/sensor/source_factory.h"
#include "roomcast/sound/microphone_source.h"

namespace roomcast::cli {
namespace {

struct SensorCommandOptions {
  std::string source;
  sensor::SourceOptions source_options;
  sensor::SensorFeedOptions feed;
  TokenOption token;
  std::string frame_log;
  std::string audio;
  bool once = false;
  bool always = false;
  bool json = false;
  bool keep_interference = false;
  bool keep_holes = false;
  bool no_remote_settings = false;
  bool verbose = false;
};

/// Nothing while other cameras do not disturb this one.
std::string interference_text(const sensor::InterferenceFigures& figures) {
  constexpr double kMinFlickering = 0.005, kMinNoiseRatio = 1.4;
  if (!figures.is_known) return {};
  std::string text;
  if (figures.flickering >= kMinFlickering)
    text += fmt::format(", {:.1f} % of still readings come and go", 100 * figures.flickering);
  if (figures.noise_ratio >= kMinNoiseRatio)
    text += fmt::format(", noise up to {:.1f} times the usual", figures.noise_ratio);
  return text.empty() ? text : text + " (infrared interference)";
}

/// Empty without a microphone.
std::string microphone_text(const std::optional<sensor::RoomMicrophoneStats>& microphone) {
  if (!microphone) return {};
  if (!microphone->is_connected) return ", waiting for the microphone";
  if (microphone->has_ended) return ", the sound has ended";
  if (!microphone->is_permitted) return ", the room does not let it be heard";
  constexpr double kSilence = 1e-5;
  return fmt::format(", sound {:.0f} dB",
                     20 * std::log10(std::max(microphone->loudness, kSilence)));
}

nlohmann::ordered_json microphone_json(const sensor::RoomMicrophoneStats& microphone) {
  return {{"connected", microphone.is_connected},
          {"permitted", microphone.is_permitted},
          {"ended", microphone.has_ended},
          {"loudness", microphone.loudness},
          {"packets_sent", microphone.packets_sent}};
}

nlohmann::ordered_json status_json(const std::string& name, const sensor::SensorFeedStats& now,
                                   const sensor::SensorFeedStats& before) {
  nlohmann::ordered_json json = {{"sensor", name},
                                 {"connected", now.source.is_connected},
                                 {"watched", now.is_watched},
                                 {"seen", now.frames_wanted},
                                 {"frames_per_s", now.frames_sent - before.frames_sent},
                                 {"bytes_per_s", now.bytes_sent - before.bytes_sent},
                                 {"frames_sent", now.frames_sent},
                                 {"frames_lost", now.source.frames_lost},
                                 {"unplugged", now.source.disconnect_count}};
  if (now.room_mbit > 0) json["room_mbit"] = now.room_mbit;
  if (now.line_mbit_per_s > 0) json["line_mbit_per_s"] = now.line_mbit_per_s;
  if (now.microphone) json["microphone"] = microphone_json(*now.microphone);
  if (now.interference.is_known) {
    json["interference"] = {{"flickering", now.interference.flickering},
                            {"noise_ratio", now.interference.noise_ratio}};
  }
  return json;
}

std::string status_text(const std::string& name, const sensor::SensorFeedStats& now,
                        const sensor::SensorFeedStats& before) {
  if (!now.source.is_connected) return name + ": waiting for the camera";
  std::string text = fmt::format(
      "{}: {} frames/s, {:.2f} MB/s, {} frames sent", name, now.frames_sent - before.frames_sent,
      static_cast<double>(now.bytes_sent - before.bytes_sent) / 1e6, now.frames_sent);
  if (now.line_mbit_per_s > 0)
    text += fmt::format(", the line carries {:.1f} Mbit/s", now.line_mbit_per_s);
  if (now.room_mbit > 0) text += fmt::format(", the room gives it {:.2f} Mbit/s", now.room_mbit);
  if (!now.frames_wanted) text += now.is_watched ? ", nobody looks at it" : ", nobody watches";
  if (now.source.frames_lost > 0) text += fmt::format(", {} lost", now.source.frames_lost);
  if (now.source.disconnect_count > 0)
    text += fmt::format(", unplugged {} times", now.source.disconnect_count);
  return text + microphone_text(now.microphone) + interference_text(now.interference);
}

/// How a sensor's time in the room ended: with `next` an admin wants it to go on so.
struct SensorEnd {
  Status status;
  std::optional<sensor::RemoteSettings> next = {};
};

/// The settings to go on with, if an admin has asked for other ones and this sensor has them.
std::optional<sensor::RemoteSettings> answer_request(sensor::SettingsMailbox& requests,
                                                     const sensor::RemoteSettings& now,
                                                     sensor::SensorFeed& feed) {
  constexpr std::chrono::milliseconds kForTheAnswer(300);  // to be on its way before we leave
  const auto request = requests.take();
  if (!request) return std::nullopt;
  const auto next = sensor::changed(now, request->settings());
  feed.answer(request->number(), next ? "" : next.error().message);
  if (!next) return std::nullopt;
  std::this_thread::sleep_for(kForTheAnswer);
  return *next;
}

SensorEnd wait_for_end(sensor::SensorFeed& feed, const std::string& name, bool json,
                       sensor::SettingsMailbox& requests, const sensor::RemoteSettings& settings,
                       const std::stop_token& stop) {
  constexpr int kLooksPerSecond = 10;
  StatusLine line;
  sensor::SensorFeedStats before;
  for (int look = 1; !stop.stop_requested(); ++look) {
    if (auto result = feed.result()) return {*result};
    if (auto next = answer_request(requests, settings, feed)) return {{}, next};
    std::this_thread::sleep_for(std::chrono::milliseconds(1000 / kLooksPerSecond));
    if (look % kLooksPerSecond != 0) continue;
    const sensor::SensorFeedStats now = feed.stats();
    if (json) {
      print_out("{}\n",
                status_json(name, now, before)
                    .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
      std::fflush(stdout);
    } else {
      line.show(status_text(name, now, before));
    }
    before = now;
  }
  return {};
}

/// The sensor in its room, with these settings.
Result<std::unique_ptr<sensor::SensorFeed>> join_room(SensorCommandOptions& options,
                                                      const sensor::RemoteSettings& settings) {
  options.source_options.sim_fps = settings.fps.value_or(options.source_options.sim_fps);
  options.feed.codec = settings.codec;
  if (!options.no_remote_settings) options.feed.settings = sensor::message_from(settings);
  auto source = sensor::open_source(options.source, options.source_options);
  if (!source) return source.error();
  if (options.feed.name.empty()) options.feed.name = (*source)->description().name;
  return sensor::SensorFeed::start(std::move(*source), options.feed);
}

sensor::RemoteSettings settings_of(const SensorCommandOptions& options) {
  sensor::RemoteSettings settings{.codec = options.feed.codec};
  if (options.source.starts_with("sim")) settings.fps = options.source_options.sim_fps;
  return settings;
}

void say(const SensorCommandOptions& options, const std::string& line) {
  if (options.json) return;
  print_out("roomcast sensor: {}\n", line);
  std::fflush(stdout);  // for who reads a pipe or a service's journal
}

/// Stays in the room until the end, and goes on with other settings when an admin asks for them;
/// with the earlier ones where the others turn out not to work.
Status stay_in_room(SensorCommandOptions& options, sensor::SettingsMailbox& requests,
                    const std::stop_token& stop) {
  sensor::RemoteSettings settings = settings_of(options);
  std::optional<sensor::RemoteSettings> earlier;
  for (;;) {
    auto feed = join_room(options, settings);
    if (!feed && stop.stop_requested()) return {};
    if (!feed && !earlier) return feed.error();
    if (!feed) {
      options.feed.log(LogLevel::kWarning,
                       "this sensor goes on as before: " + feed.error().message);
      settings = *std::exchange(earlier, std::nullopt);
      continue;
    }
    say(options, fmt::format("joined as \"{}\"", options.feed.name));
    const SensorEnd end =
        wait_for_end(**feed, options.feed.name, options.json, requests, settings, stop);
    say(options,
        fmt::format("{} frames sent as \"{}\"", (*feed)->stats().frames_sent, options.feed.name));
    if (!end.next) return end.status;
    say(options, "an admin of the room wants other settings or a new start");
    earlier = std::exchange(settings, *end.next);
    options.feed.wait_for_hub = true;  // it was there a moment ago
    options.feed.append_to_frame_log = true;
    if (!requests.token().empty())
      options.feed.credential = {.token = requests.token(), .code = {}};
  }
}

Status run_sensor(SensorCommandOptions options) {
  StopOnSignal stop;
  options.source_options.loop = !options.once;
  options.source_options.stop = stop.token();
  options.source_options.log = stderr_log("sensor", options.verbose);
  auto credential = find_credential(options.token);
  if (!credential) return credential.error();
  options.feed.credential = *std::move(credential);
  options.feed.log = stderr_log("sensor", options.verbose);
  options.feed.filter_interference = !options.keep_interference;
  options.feed.fill_holes = !options.keep_holes;
  if (!options.audio.empty())
    options.feed.microphone = [audio = options.audio, loops = !options.once] {
      return sound::open_microphone(audio, loops);
    };
  if (!options.frame_log.empty()) options.feed.frame_log = options.frame_log;
  options.feed.follows_rate = !options.no_remote_settings;
  options.feed.send_unwatched = options.always || options.once;
  options.feed.stop = stop.token();
  sensor::SettingsMailbox requests;
  options.feed.on_settings_request = [&requests](const wire::pb::SettingsRequest& request) {
    requests.put(request);
  };
  options.feed.on_token = [&requests](const std::string& token) { requests.keep_token(token); };
  return stay_in_room(options, requests, stop.token());
}

}  // namespace

void add_sensor_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<SensorCommandOptions>();
  CLI::App* command = app.add_subcommand("sensor", "Send one sensor's depth and colour to a hub");
  command
      ->add_option("--source", options->source,
                   "sim[:scene][#n], rig:DIR#s0, tum:DIR, mcap:FILE#s0, or a camera: freenect:0, "
                   "openni2:[FILE.oni], realsense:, freenect2:, k4a: (roomcast devices lists them)")
      ->required();
  add_hub_option(*command, options->feed.hub_url);
  command->add_option("--room", options->feed.room, "The room (default: the hub's only one)");
  command->add_option(
      "--name", options->feed.name,
      "Its name in the room (default: the source's); it keeps its ID and pose by this name");
  add_token_options(*command, options->token);
  command
      ->add_option("--fps", options->source_options.sim_fps,
                   "Frames per second of a simulated sensor")
      ->check(within(1.0, 60.0))
      ->capture_default_str();
  command
      ->add_option("--sensors", options->source_options.sim_sensor_count,
                   "Simulated: number of sensors around the room")
      ->check(within(1, 8))
      ->capture_default_str();
  add_camera_options(*command, options->source_options);
  command->add_option("--preview", options->feed.preview,
                      "JPEG file, rewritten each second with the sensor's picture");
  command->add_option(
      "--audio", options->audio,
      std::string("A microphone whose sound is heard from where the sensor stands: ") +
          sound::kMicrophoneSources);
  add_codec_options(*command, options->feed.codec);
  command->add_flag("--keep-interference", options->keep_interference,
                    "With --codec live: do not remove what the infrared light of other cameras "
                    "does to depth");
  command->add_flag("--keep-holes", options->keep_holes,
                    "With --codec live: do not fill the holes of large planes, such as glossy "
                    "floors, nor those between scattered readings, as of dark screens");
  command->add_flag(
      "--no-remote-settings", options->no_remote_settings,
      "Let no admin of the room change codec and rate, or restart this sensor, and do "
      "not keep to a share of the room's uplink");
  command->add_flag("--json", options->json,
                    "Print a line of JSON each second instead of a status");
  command->add_flag("--once", options->once,
                    "Stop at the end of a recording instead of starting again; implies --always");
  command->add_flag("--always", options->always,
                    "Send while nobody watches the room, too (default: capture a few frames a "
                    "second, and send none)");
  command->add_flag("--wait", options->feed.wait_for_hub, "Keep trying while no hub answers");
  command->add_option("--log-frames", options->frame_log,
                      "Write one JSON line per frame sent: seq, capture_ns, depth_crc32");
  command->add_flag("--verbose", options->verbose, "Log joins");
  command->footer(
      "Examples:\n  roomcast sensor --source rig:recordings/lab#s0 --hub ws://127.0.0.1:7600\n"
      "  roomcast sensor --source freenect:0 --audio default");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("sensor", run_sensor(*options)); };
  });
}

}  // namespace roomcast::cli
