// SPDX-License-Identifier: Apache-2.0
// roomcast info: summarises a recording. Reads every frame, so it also detects damage.
#include <chrono>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/recording.h"
#include "roomcast/recording/export/thumbnail_strip.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"
#include "roomcast/recording/import/open_recording.h"
#include "roomcast/recording/playback/replay_source.h"
#include "roomcast/recording/room/room_recording.h"
#include "roomcast/sensor/frame_log.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::cli {
namespace {

struct InfoOptions {
  std::string recording;
  std::string thumbnails;
  bool json = false;
};

/// Summary of one sensor of a recording.
struct SensorInfo {
  source::SensorDescription sensor;
  std::size_t frames = 0;
  std::size_t frames_with_color = 0;
  double seconds = 0;  // from its first frame to its last
  std::vector<std::uint32_t> depth_crc32;
};

/// Of a recording of another program.
Result<std::vector<std::string>> specs_of_import(std::string_view kind, const std::string& file) {
  const auto files = recording::open_recording(kind, file);
  if (!files) return files.error();
  std::vector<std::string> specs;
  for (const auto& sensor : *files) {
    const std::string& name = sensor->info().description.name;
    specs.push_back(std::string(kind) + ":" + file + "#" + name);
    for (const std::string& note : sensor->info().notes)
      print_err("roomcast info: {}: {}\n", name, note);
  }
  return specs;
}

Result<std::vector<std::string>> specs_of_file(const std::string& file) {
  auto names = recording::replay_sensor_names(file);
  const std::string_view kind = names ? std::string_view() : recording::import_kind_of(file);
  if (!kind.empty()) {
    auto specs = specs_of_import(kind, file);
    // An MCAP file that is neither may be a damaged recording of a room.
    if (specs || kind != "ros2") return specs;
  }
  if (!names) return names.error();
  std::vector<std::string> specs;
  for (const auto& name : *names) specs.push_back("mcap:" + file + "#" + name);
  return specs;
}

/// A file is a recorded room, a folder with rig.json is a rig, a folder with depth.txt is a TUM
/// recording.
Result<std::vector<std::string>> specs_of(const std::string& recording) {
  const std::filesystem::path folder(recording);
  std::error_code ignored;
  if (std::filesystem::is_regular_file(folder, ignored)) return specs_of_file(recording);
  if (!std::filesystem::is_directory(folder, ignored)) {
    return Error{ErrorCode::kNotFound, "there is no recording " + recording};
  }
  if (std::filesystem::exists(folder / "depth.txt", ignored))
    return std::vector{"tum:" + recording};
  if (!std::filesystem::exists(folder / "rig.json", ignored)) {
    return Error{ErrorCode::kNotFound,
                 recording + " is not a recording: it has neither rig.json nor depth.txt"};
  }
  auto names = recording::rig_sensor_names(recording);
  if (!names) return names.error();
  std::vector<std::string> specs;
  for (const auto& name : *names) specs.push_back("rig:" + recording + "#" + name);
  return specs;
}

Error read_in_part() {
  return {ErrorCode::kClosed, "interrupted before the recording was read to its end"};
}

Result<SensorInfo> read_sensor(const std::string& spec, const std::stop_token& stop) {
  sensor::SourceOptions options;
  options.pace = source::Pace::kAsFastAsPossible;
  options.loop = false;
  auto source = sensor::open_source(spec, options);
  if (!source) return source.error();
  StatusLine line;
  SensorInfo info;
  info.sensor = (*source)->description();
  source::CapturedFrame frame;
  nanoseconds first{};
  for (;;) {
    auto more = (*source)->next(frame, stop);
    if (!more) return more.error();
    if (stop.stop_requested()) return read_in_part();  // figures of a part would be wrong ones
    if (!*more) return info;
    if (info.frames++ == 0) first = frame.device_time;
    info.seconds = std::chrono::duration<double>(frame.device_time - first).count();
    info.frames_with_color += !frame.color.empty();
    info.depth_crc32.push_back(sensor::depth_crc32(frame.depth_mm));
    line.show(fmt::format("{}: {} frames", info.sensor.name, info.frames));
  }
}

nlohmann::json json_of(const SensorInfo& info) {
  const auto& [depth, color, color_from_depth, registered] = info.sensor.calibration;
  return {{"id", info.sensor.name},
          {"depth_size", {depth.width, depth.height}},
          {"color_size", {color.width, color.height}},
          {"fps", info.sensor.fps},
          {"placed", info.sensor.world_from_depth.has_value()},
          {"frames", info.frames},
          {"frames_with_color", info.frames_with_color},
          {"seconds", info.seconds},
          {"depth_crc32", info.depth_crc32}};
}

void print_text(const SensorInfo& info) {
  const auto& [depth, color, color_from_depth, registered] = info.sensor.calibration;
  print_out(
      "{}: depth {}x{}, colour {}x{}, {} frames ({} with colour) in {:.2f} s, nominally {:.4g}/s, "
      "{}\n",
      info.sensor.name, depth.width, depth.height, color.width, color.height, info.frames,
      info.frames_with_color, info.seconds, info.sensor.fps,
      info.sensor.world_from_depth ? "placed" : "not placed");
}

double room_seconds(const recording::RoomRecording& room) {
  return std::chrono::duration<double>(room.end() - room.start()).count();
}

/// Reads the whole recording again and writes thumbnails.
Status write_thumbnails(const InfoOptions& options, const std::stop_token& stop) {
  auto reader = recording::open_frame_sets(options.recording);
  if (!reader) return reader.error();
  recording::ThumbnailStrip strip((*reader)->sensors());
  StatusLine line;
  recording::FrameSet set;
  for (;;) {
    if (stop.stop_requested()) return read_in_part();
    const auto more = (*reader)->next(set);
    if (!more) return more.error();
    if (!*more) break;
    strip.add(set);
    line.show(fmt::format("thumbnails: {} frame sets", set.number + 1));
  }
  const ColorImage picture = strip.picture();
  if (picture.empty()) return Error{ErrorCode::kNotFound, "there is no frame to show"};
  return io::write_color_png(options.thumbnails, picture);
}

/// "2026-11-24T03:10:19Z"; nothing if no message was recorded.
std::string begin_of(const recording::RoomRecording& room) {
  if (room.start() == nanoseconds(0)) return {};
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(room.start()).count();
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

void print_room(const recording::RoomRecording& room) {
  const std::string begin = begin_of(room);
  print_out("room \"{}\": {:.2f} s{}\n", room.room(), room_seconds(room),
            begin.empty() ? "" : ", recorded from " + begin);
  if (room.sensors().empty())
    print_out("no sensors: the recording ended before the first frame of a sensor\n");
}

/// Of a recorded room: what does not belong to a single sensor, and, with the reason, a warning if
/// the end of the file is missing.
void tell_of_room(const InfoOptions& options, nlohmann::json& report) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(options.recording, ignored)) return;
  const auto room = recording::RoomRecording::open(options.recording);
  if (!room) return;  // reading its sensors fails with the reason
  if (room->damage())
    print_err("roomcast info: {}; everything before it was read\n", *room->damage());
  if (!options.json) return print_room(*room);
  report["room"] = room->room();
  report["begin"] = begin_of(*room);
  report["seconds"] = room_seconds(*room);
}

Status run_info(const InfoOptions& options) {
  StopOnSignal stop;
  nlohmann::json report = {{"recording", options.recording}, {"sensors", nlohmann::json::array()}};
  tell_of_room(options, report);
  const auto specs = specs_of(options.recording);
  if (!specs) return specs.error();
  for (const auto& spec : *specs) {
    if (stop.token().stop_requested()) return read_in_part();
    const auto info = read_sensor(spec, stop.token());
    if (!info) return info.error();
    if (options.json) {
      report["sensors"].push_back(json_of(*info));
    } else {
      print_text(*info);
    }
  }
  if (!options.thumbnails.empty()) {
    if (auto status = write_thumbnails(options, stop.token()); !status) return status;
  }
  if (options.json) print_out("{}\n", report.dump(1));
  return {};
}

}  // namespace

void add_info_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Read a whole recording and describe it");
  command
      ->add_option("recording", options->recording,
                   "FILE.mcap, the folder of a rig or of a TUM recording, or a recording of "
                   "another program")
      ->required();
  command->add_flag("--json", options->json, "Print JSON, with a CRC-32 of every depth picture");
  command->add_option("--thumbnails", options->thumbnails,
                      "Write OUT.png: pictures of each sensor from the whole recording");
  command->footer("Example:\n  roomcast info lab.mcap --thumbnails lab.png");
  command->callback(
      [options, &chosen] { chosen = [options] { return finish("info", run_info(*options)); }; });
}

}  // namespace roomcast::cli
