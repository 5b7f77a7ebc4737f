// SPDX-License-Identifier: Apache-2.0
// roomcast measure: distances in a recorded room, and its floor plan.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"
#include "roomcast/recording/measure/distance.h"
#include "roomcast/recording/measure/floor_plan.h"
#include "roomcast/recording/measure/static_room.h"

namespace roomcast::cli {
namespace {

struct MeasureOptions {
  std::string recording;
  std::string from, to;
  std::string floor_plan;
  double at_s = 0;
  bool json = false;
};

Result<std::vector<recording::StaticSensor>> read_room(const MeasureOptions& options) {
  auto reader = recording::open_frame_sets(
      options.recording, nanoseconds(static_cast<std::int64_t>(options.at_s * 1e9)));
  if (!reader) return reader.error();
  StatusLine line;
  return recording::gather_static_room(**reader, [&line](std::size_t sets) {
    line.show_progress("reading", static_cast<int>(sets),
                       static_cast<int>(recording::kMaxStaticFrames));
  });
}

nlohmann::json json_of(const recording::MeasuredPlace& place) {
  return {{"world_m", {place.world_m.x(), place.world_m.y(), place.world_m.z()}},
          {"sensor", place.sensor}};
}

/// Where a good part of the error is that of the room's scale.
std::string scale_text(const recording::MeasuredDistance& measured) {
  if (measured.by_scale_m < 0.5 * measured.expected_error_m || measured.by_scale_m <= 0) return "";
  return fmt::format(", of which {:.0f} mm because the room's scale is not known better",
                     1000 * measured.by_scale_m);
}

Status report_distance(const MeasureOptions& options,
                       const std::vector<recording::StaticSensor>& room, nlohmann::json& report) {
  const auto from = recording::parse_place(options.from);
  if (!from) return from.error();
  const auto to = recording::parse_place(options.to);
  if (!to) return to.error();
  const auto measured = recording::measure_distance(room, *from, *to);
  if (!measured) return measured.error();
  report["distance_m"] = measured->distance_m;
  report["expected_error_m"] = measured->expected_error_m;
  report["by_scale_m"] = measured->by_scale_m;
  report["from"] = json_of(measured->from);
  report["to"] = json_of(measured->to);
  if (!options.json) {
    print_out("{:.3f} m ± {:.0f} mm{}\n", measured->distance_m, 1000 * measured->expected_error_m,
              scale_text(*measured));
  }
  return {};
}

Status report_plan(const MeasureOptions& options, const std::vector<recording::StaticSensor>& room,
                   nlohmann::json& report) {
  const auto plan = recording::draw_floor_plan(room);
  if (!plan) return plan.error();
  const std::string title = std::filesystem::path(options.recording).stem().string();
  if (auto status = io::write_file(options.floor_plan, recording::floor_plan_svg(*plan, title));
      !status)
    return status;
  for (const recording::Wall& wall : plan->walls) {
    report["walls"].push_back({{"from", {wall.from_m.x(), wall.from_m.y()}},
                               {"to", {wall.to_m.x(), wall.to_m.y()}},
                               {"length_m", wall.length_m()}});
  }
  report["floor_plan"] = options.floor_plan;
  if (!options.json) print_out("{}: {} walls\n", options.floor_plan, plan->walls.size());
  return {};
}

Status run_measure(const MeasureOptions& options) {
  const bool distance = !options.from.empty() && !options.to.empty();
  if (!distance && options.floor_plan.empty()) {
    return Error{ErrorCode::kInvalidArgument, "give --from and --to, or --floor-plan"};
  }
  const auto room = read_room(options);
  if (!room) return room.error();
  nlohmann::json report = nlohmann::json::object();
  if (distance) {
    if (auto status = report_distance(options, *room, report); !status) return status;
  }
  if (!options.floor_plan.empty()) {
    if (auto status = report_plan(options, *room, report); !status) return status;
  }
  if (options.json) print_out("{}\n", report.dump(1));
  return {};
}

}  // namespace

void add_measure_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<MeasureOptions>();
  CLI::App* command =
      app.add_subcommand("measure", "Measure in a recorded room: a distance, or its floor plan");
  command->add_option("recording", options->recording, "FILE.mcap, or the folder of a rig")
      ->required();
  command->add_option("--from", options->from,
                      "First place: SENSOR:x,y (a pixel of its depth) or x,y,z (metres)");
  command->add_option("--to", options->to, "Second place");
  command->add_option("--floor-plan", options->floor_plan, "Write the floor plan, OUT.svg");
  command->add_option("--at", options->at_s, "Measure from this second on")
      ->check(seconds_from_zero());
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "The median of many frames is measured, without people who walk through.\n"
      "Example:\n  roomcast measure lab.mcap --from s0:100,200 --to s0:400,210\n"
      "  roomcast measure lab.mcap --floor-plan lab.svg");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("measure", run_measure(*options)); };
  });
}

}  // namespace roomcast::cli
