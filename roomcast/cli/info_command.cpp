// SPDX-License-Identifier: Apache-2.0
// roomcast info: what is in a recording. Reads every frame, so it also says whether the recording
// is sound.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/frame_log.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/source/source_factory.h"

namespace roomcast::cli {
namespace {

struct InfoOptions {
  std::string recording;
  bool json = false;
};

/// What one sensor of a recording holds.
struct SensorInfo {
  SensorDescription sensor;
  std::size_t frames = 0;
  std::size_t frames_with_color = 0;
  double seconds = 0;  // from its first frame to its last
  std::vector<std::uint32_t> depth_crc32;
};

/// A folder with rig.json is a rig, one with depth.txt a TUM recording.
Result<std::vector<std::string>> specs_of(const std::string& recording) {
  const std::filesystem::path folder(recording);
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) {
    return Error{ErrorCode::kNotFound, "there is no folder " + recording};
  }
  if (std::filesystem::exists(folder / "depth.txt", ignored))
    return std::vector{"tum:" + recording};
  if (!std::filesystem::exists(folder / "rig.json", ignored)) {
    return Error{ErrorCode::kNotFound,
                 recording + " is no recording: it has neither rig.json nor depth.txt"};
  }
  auto names = rig_sensor_names(recording);
  if (!names) return names.error();
  std::vector<std::string> specs;
  for (const auto& name : *names) specs.push_back("rig:" + recording + "#" + name);
  return specs;
}

Result<SensorInfo> read_sensor(const std::string& spec, const std::stop_token& stop) {
  SourceOptions options;
  options.pace = Pace::kAsFastAsPossible;
  options.loop = false;
  auto source = open_source(spec, options);
  if (!source) return source.error();
  StatusLine line;
  SensorInfo info;
  info.sensor = (*source)->description();
  CapturedFrame frame;
  nanoseconds first{};
  for (;;) {
    auto more = (*source)->next(frame, stop);
    if (!more) return more.error();
    if (!*more) return info;
    if (info.frames++ == 0) first = frame.device_time;
    info.seconds = std::chrono::duration<double>(frame.device_time - first).count();
    info.frames_with_color += !frame.color.empty();
    info.depth_crc32.push_back(depth_crc32(frame.depth_mm));
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
  fmt::print(
      "{}: depth {}x{}, colour {}x{}, {} frames ({} with colour) in {:.2f} s, nominally {:.4g}/s, "
      "{}\n",
      info.sensor.name, depth.width, depth.height, color.width, color.height, info.frames,
      info.frames_with_color, info.seconds, info.sensor.fps,
      info.sensor.world_from_depth ? "placed" : "not placed");
}

Status run_info(const InfoOptions& options) {
  StopOnSignal stop;
  const auto specs = specs_of(options.recording);
  if (!specs) return specs.error();
  nlohmann::json report = {{"recording", options.recording}, {"sensors", nlohmann::json::array()}};
  for (const auto& spec : *specs) {
    const auto info = read_sensor(spec, stop.token());
    if (!info) return info.error();
    if (options.json) {
      report["sensors"].push_back(json_of(*info));
    } else {
      print_text(*info);
    }
  }
  if (options.json) fmt::print("{}\n", report.dump(1));
  return {};
}

}  // namespace

void add_info_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command =
      app.add_subcommand("info", "Read a recording from end to end and say what is in it");
  command->add_option("recording", options->recording, "Folder of a rig or of a TUM recording")
      ->required();
  command->add_flag("--json", options->json, "For scripts; with a CRC-32 of every depth picture");
  command->footer("Example:\n  roomcast info recordings/lab --json");
  command->callback(
      [options, &chosen] { chosen = [options] { return finish("info", run_info(*options)); }; });
}

}  // namespace roomcast::cli
