// SPDX-License-Identifier: Apache-2.0
// roomcast record: writes the stream of a hub's rooms into files, one file per room.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "roomcast/cli/command.h"
#include "roomcast/cli/hub_option.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stderr_log.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/cli/token_option.h"
#include "roomcast/io/private_folder.h"
#include "roomcast/recording/recorder/recorder.h"

namespace roomcast::cli {
namespace {

using namespace std::chrono_literals;
using Recorders = std::vector<std::unique_ptr<recording::Recorder>>;

struct RecordOptions {
  std::filesystem::path out;
  std::string hub_url;
  std::vector<std::string> rooms;
  TokenOption token;
  bool no_voices = false;
  bool bundles = false;
  double seconds = 0;
  bool json = false;
  bool verbose = false;
};

/// The file of `room`. With several rooms, each has a file of its name in the folder OUT.
std::filesystem::path file_of(const RecordOptions& options, const std::string& room) {
  return options.rooms.size() < 2 ? options.out : options.out / (room + ".mcap");
}

Status make_folder(const RecordOptions& options) {
  if (options.rooms.size() < 2) return {};
  for (const auto& room : options.rooms) {
    if (room.empty() || room[0] == '.' || room.find('/') != std::string::npos)
      return Error{ErrorCode::kInvalidArgument,
                   "\"" + room + "\" cannot be a file's name; give the rooms other names"};
  }
  const auto was_open = io::make_private_folder(options.out, {".mcap"});
  if (!was_open) return was_open.error();
  if (*was_open) {
    print_err(
        "roomcast record: other users of this machine could enter {}; it is closed to them now\n",
        options.out.string());
  }
  return {};
}

Result<Recorders> start_recorders(const RecordOptions& options,
                                  const client::Credential& credential,
                                  const std::stop_token& stop) {
  if (auto status = make_folder(options); !status) return status.error();
  Recorders recorders;
  const auto rooms = options.rooms.empty() ? std::vector<std::string>{""} : options.rooms;
  for (const auto& room : rooms) {
    recording::RecorderOptions recorder;
    recorder.hub_url = options.hub_url;
    recorder.room = room;
    recorder.credential = credential;
    recorder.voices = !options.no_voices;
    recorder.bundles = options.bundles;
    recorder.path = file_of(options, room);
    recorder.log = stderr_log("record", options.verbose);
    recorder.stop = stop;
    auto opened = recording::Recorder::open(std::move(recorder));
    if (!opened) return opened.error();
    recorders.push_back(std::move(*opened));
  }
  return recorders;
}

recording::RecorderStats sum(const Recorders& recorders) {
  recording::RecorderStats sum;
  for (const auto& recorder : recorders) {
    const recording::RecorderStats stats = recorder->stats();
    sum.frames += stats.frames;
    sum.frame_bytes += stats.frame_bytes;
    sum.file_bytes += stats.file_bytes;
  }
  return sum;
}

/// Waits until a stop request, until `seconds` have passed (0: no limit), or until no recorder can
/// continue.
Status wait_for_end(const Recorders& recorders, double seconds, const std::stop_token& stop) {
  StatusLine line;
  const auto begin = std::chrono::steady_clock::now();
  for (int tenths = 1; !stop.stop_requested(); ++tenths) {
    std::this_thread::sleep_for(100ms);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    for (const auto& recorder : recorders) {
      if (auto failure = recorder->failure()) return *failure;
    }
    if (seconds > 0 && elapsed.count() >= seconds) break;
    if (tenths % 10 != 0) continue;
    const recording::RecorderStats stats = sum(recorders);
    line.show(fmt::format("{:.0f} s, {} frames, {:.1f} MB   (Ctrl-C ends the recording)",
                          elapsed.count(), stats.frames,
                          static_cast<double>(stats.file_bytes) / 1e6));
  }
  return {};
}

/// CPU time of this process: the cost of recording.
double cpu_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Of all speakers together.
double voice_seconds(const recording::RecorderStats& stats) {
  constexpr double kPacket_s = 0.02;
  return kPacket_s * static_cast<double>(stats.voice_packets);
}

void report(const RecordOptions& options, const Recorders& recorders, double elapsed_s,
            const Status& status) {
  nlohmann::json rooms = nlohmann::json::array();
  for (const auto& recorder : recorders) {
    const recording::RecorderStats stats = recorder->stats();
    const std::string file =
        file_of(options, options.rooms.size() < 2 ? "" : recorder->room()).string();
    rooms.push_back({{"room", recorder->room()},
                     {"file", file},
                     {"frames", stats.frames},
                     {"frame_bytes", stats.frame_bytes},
                     {"voice_seconds", voice_seconds(stats)},
                     {"file_bytes", std::filesystem::file_size(file)}});
    if (!options.json) {
      print_out("{}: {} frames, {:.2f} MB", file, stats.frames,
                static_cast<double>(std::filesystem::file_size(file)) / 1e6);
      if (stats.voice_packets > 0) print_out(", {:.0f} s of voices", voice_seconds(stats));
      print_out("\n");
    }
  }
  if (!options.json) return;
  nlohmann::json json = {{"rooms", rooms}, {"seconds", elapsed_s}, {"cpu_seconds", cpu_seconds()}};
  add_error(status, json);
  print_out("{}\n", json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
}

Outcome run_record(const RecordOptions& options) {
  StopOnSignal stop;
  const auto credential = find_credential(options.token);
  if (!credential) return credential.error();
  auto recorders = start_recorders(options, *credential, stop.token());
  if (!recorders) return recorders.error();
  const auto begin = std::chrono::steady_clock::now();
  Status status = wait_for_end(*recorders, options.seconds, stop.token());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  for (const auto& recorder : *recorders) {
    if (auto finished = recorder->finish(); status && !finished) status = finished;
  }
  report(options, *recorders, elapsed.count(), status);
  return {status, true};
}

}  // namespace

void add_record_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App* command =
      app.add_subcommand("record", "Record a room: frames and voices as the hub sends them");
  command->add_option("out", options->out, "New file OUT.mcap; a folder for several rooms")
      ->required();
  add_hub_option(*command, options->hub_url);
  command->add_option("--room", options->rooms,
                      "The room (default: the hub's only one); may be given several times");
  add_token_options(*command, options->token);
  command->add_flag("--no-voices", options->no_voices, "Leave out people's voices");
  command->add_flag("--bundles", options->bundles,
                    "Record calibration bundles, too; needs an admin's token");
  command->add_option("--seconds", options->seconds, "Stop after this time (default: Ctrl-C)")
      ->check(seconds_from_zero());
  command->add_flag("--json", options->json, "Print JSON, with the processor time used");
  command->add_flag("--verbose", options->verbose, "Log the connection's state");
  command->footer(
      "The file is a standard MCAP file; docs/spec/recording.md describes it.\n"
      "Example:\n  roomcast record lab.mcap --hub ws://127.0.0.1:7600 --seconds 60");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("record", run_record(*options)); };
  });
}

}  // namespace roomcast::cli
