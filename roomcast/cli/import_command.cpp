// SPDX-License-Identifier: Apache-2.0
// roomcast import: turns recordings of other programs into one rig.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/clock_option.h"
#include "roomcast/cli/command.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/recording/import/open_recording.h"
#include "roomcast/recording/import/rig_import.h"
#include "roomcast/recording/import/sensor_name.h"

namespace roomcast::cli {
namespace {

struct ImportOptions {
  std::vector<std::string> paths;  // recordings, then the new folder
  recording::JoiningClock clock = recording::JoiningClock::kAutomatic;
  int jpeg_quality = 90;
  bool json = false;
};

/// The recordings' sensors, each with the file that it is from.
struct Found {
  recording::SensorFiles files;
  std::vector<std::string> places, names;
};

Result<Found> find_sensors(const std::vector<std::string>& paths) {
  Found found;
  for (auto path = paths.begin(); path + 1 != paths.end(); ++path) {
    auto files = recording::open_any(*path);
    if (!files) return files.error();
    for (auto& file : *files) {
      found.names.push_back(file->info().description.name);
      found.places.push_back(*path);
      found.files.push_back(std::move(file));
    }
  }
  recording::make_unique(found.names);
  return found;
}

nlohmann::json json_of(const recording::ImportedSensor& sensor, const recording::SensorFile& file,
                       const std::string& place) {
  const auto& info = file.info();
  const nanoseconds length = info.times.back() - info.times.front();
  nlohmann::json json = {
      {"id", sensor.name},         {"from", place},
      {"frames", sensor.frames},   {"frames_with_color", sensor.colors},
      {"damaged", sensor.damaged}, {"seconds", std::chrono::duration<double>(length).count()},
      {"notes", info.notes}};
  if (info.clock.utc_minus_device)
    json["begin_utc_ns"] = (info.times.front() + *info.clock.utc_minus_device).count();
  return json;
}

void report(const ImportOptions& options, const Found& found,
            const std::vector<recording::ImportedSensor>& sensors,
            const recording::RoomTimeline& timeline, const Status& status) {
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    for (const std::string& note : found.files[i]->info().notes)
      print_err("roomcast import: {}: {}\n", found.places[i], note);
    if (sensors[i].damaged > 0) {
      print_err("roomcast import: {} of {} frames of {} are damaged; the first: {}\n",
                sensors[i].damaged, found.files[i]->info().times.size(), sensors[i].name,
                sensors[i].first_damage);
    }
    list.push_back(json_of(sensors[i], *found.files[i], found.places[i]));
    if (!options.json)
      print_out("{}: {} frames, {} with colour\n", sensors[i].name, sensors[i].frames,
                sensors[i].colors);
  }
  if (options.json) {
    nlohmann::json json = {{"out", options.paths.back()},
                           {"fps", timeline.fps},
                           {"clock", timeline.explanation},
                           {"sensors", list}};
    add_error(status, json);
    print_out("{}\n", json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
    return;
  }
  if (sensors.size() > 1) print_out("joined by {}\n", timeline.explanation);
  print_out("written to {}; play it: roomcast demo --rig {}\n", options.paths.back(),
            options.paths.back());
}

Outcome run_import(const ImportOptions& options) {
  StopOnSignal stop;
  const auto found = find_sensors(options.paths);
  if (!found) return found.error();
  std::vector<const recording::SensorFileInfo*> infos;
  for (const auto& file : found->files) infos.push_back(&file->info());
  const auto timeline = recording::join_clocks(infos, options.clock);
  if (!timeline) return timeline.error();
  StatusLine line;
  recording::RigImportOptions rig{
      .names = found->names, .source = "roomcast import", .jpeg_quality = options.jpeg_quality};
  rig.progress = [&line](std::uint64_t done, std::uint64_t total) {
    line.show_progress("writing frames", static_cast<int>(done), static_cast<int>(total));
  };
  const auto sensors =
      recording::import_rig(options.paths.back(), found->files, *timeline, rig, stop.token());
  if (!sensors) return sensors.error();
  Status status;
  const auto empty = std::ranges::find(*sensors, 0U, &recording::ImportedSensor::frames);
  if (empty != sensors->end())
    status = malformed("nothing of " + empty->name + " could be read: " + empty->first_damage);
  report(options, *found, *sensors, *timeline, status);
  return {status, true};
}

}  // namespace

void add_import_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* command =
      app.add_subcommand("import", "Turn recordings of other programs into one rig folder");
  command
      ->add_option("paths", options->paths,
                   "Recordings, or folders of them, of the cameras of one room; then the folder "
                   "to write")
      ->required()
      ->expected(2, 64);
  add_clock_option(*command, options->clock);
  command
      ->add_option("--jpeg-quality", options->jpeg_quality,
                   "Of colour that is not recorded as JPEG (that is kept as it is)")
      ->check(within(1, 100))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Formats: .mkv of k4arecorder (Azure Kinect), .bag of RealSense cameras and of ROS 1,\n"
      ".mcap and .db3 of ROS 2, .mcap of Foxglove's schemas (roomcast export writes it, too),\n"
      ".sens of ScanNet, .r3d of Record3D, folders of cwipc with a cameraconfig.json, folders of\n"
      "pictures with a recording.toml.\n"
      "Example:\n"
      "  roomcast import left.mkv right.mkv lab\n"
      "  roomcast demo --rig lab");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("import", run_import(*options)); };
  });
}

}  // namespace roomcast::cli
