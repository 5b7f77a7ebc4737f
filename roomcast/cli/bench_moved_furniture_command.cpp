// SPDX-License-Identifier: Apache-2.0
// roomcast bench moved-furniture: how soon the model of a running room forgets what was moved.
#include <iostream>
#include <memory>
#include <string>

#include "bench/model/moved_furniture.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/simulator/scene/room.h"

namespace roomcast::cli {
namespace {

Status run_moves(const bench::MovedFurnitureOptions& options) {
  StatusLine line;
  const auto report =
      bench::run_moved_furniture(options, [&line](const std::string& next) { line.show(next); });
  if (!report) return report.error();
  bench::print_table(*report, std::cout);
  return {};
}

}  // namespace

void add_moved_furniture_bench(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<bench::MovedFurnitureOptions>();
  CLI::App* command = bench.add_subcommand(
      "moved-furniture", "How soon the model of a running room forgets a cabinet that was moved");
  command->add_option("--scene", options->scene, "Simulated room")->capture_default_str();
  command->add_option("--seed", options->seed, "Of the room")->capture_default_str();
  command->add_option("--sensors", options->sensors, "Number of sensors")
      ->check(CLI::Range(1, simulator::kMaxSimulatedSensors))
      ->capture_default_str();
  command->add_option("--fps", options->fps, "Frames per second of a sensor")
      ->check(within(1, 30))
      ->capture_default_str();
  command->add_option("--every", options->stretch_s, "Seconds from one move to the next")
      ->check(within(10, 3600))
      ->capture_default_str();
  command->add_option("--moves", options->moves, "Number of moves")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--looking", options->looks,
                    "The viewer says where it looks, so that key frames are rare");
  command->footer("Example:\n  roomcast bench moved-furniture --every 60 --moves 1 --sensors 2");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("bench moved-furniture", run_moves(*options)); };
  });
}

}  // namespace roomcast::cli
