// SPDX-License-Identifier: Apache-2.0
// roomcast simulate: writes a recording of a simulated room, with its truth.
#include <memory>
#include <string>

#include <fmt/format.h>

#include "roomcast/cli/command.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/source/simulate_rig.h"
#include "roomcast/source/simulator/simulated_source.h"

namespace roomcast::cli {
namespace {

Status run_simulate(const std::string& out, const SimulateRigOptions& options) {
  StatusLine line;
  line.show("building the room");
  return simulate_rig(out, options, [&line](int done, int total) {
    line.show(fmt::format("{} of {} frames written", done, total));
  });
}

}  // namespace

void add_simulate_command(CLI::App& app, Command& chosen) {
  auto out = std::make_shared<std::string>();
  auto options = std::make_shared<SimulateRigOptions>();
  CLI::App* command =
      app.add_subcommand("simulate", "Write a recording of a simulated room, with its truth");
  command->add_option("out", *out, "Folder to make")->required();
  command->add_option("--scene", options->scene, "livingroom (default) or office");
  command->add_option("--sensors", options->sensor_count, "How many stand around the room")
      ->check(CLI::Range(1, 8))
      ->capture_default_str();
  command->add_option("--seconds", options->seconds, "Length")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--fps", options->fps, "Frames per second")
      ->check(CLI::Range(1.0, kMaxSimulatedFps))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of noise and looks")->capture_default_str();
  command
      ->add_option("--speed", options->speed,
                   "Of all motion: 1 as in life, 0.05 slow motion, 0 none")
      ->check(CLI::Range(0.0, kMaxSimulatedSpeed))
      ->capture_default_str();
  command->add_flag("--truth-color", options->truth_color,
                    "Write noise-free colour into truth/, too");
  command->add_flag("--clean", options->clean, "Without noise");
  command->footer("Example:\n  roomcast simulate recordings/sim --sensors 3 --seconds 5 --seed 7");
  command->callback([out, options, &chosen] {
    chosen = [out, options] { return finish("simulate", run_simulate(*out, *options)); };
  });
}

}  // namespace roomcast::cli
