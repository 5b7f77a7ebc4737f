// SPDX-License-Identifier: Apache-2.0
// roomcast simulate: writes a recording of a simulated room, with ground truth.
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "roomcast/cli/command.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/recording/dataset/rig_writer.h"
#include "roomcast/simulator/rig/simulate_rig.h"
#include "roomcast/simulator/scene/room.h"
#include "roomcast/simulator/sensing/harsh_unit.h"
#include "roomcast/simulator/simulated_source.h"
#include "roomcast/simulator/simulated_spec.h"

namespace roomcast::cli {
namespace {

struct SimulateCommand {
  std::string out;
  simulator::SimulateRigOptions rig;
  std::string camera = "kinect2";
  double lost_percent = 0.5;
  bool clean = false;
  std::string harsh;  // empty: no
  const CLI::Option *seconds = nullptr, *fps = nullptr, *mutual = nullptr;
};

/// A harsh recording has a length and a rate of its own, unless they are given.
void draw_length(SimulateCommand& command) {
  const auto drawn = simulator::draw_harsh_recording(command.rig.seed);
  if (command.fps->count() == 0) command.rig.fps = drawn.fps;
  if (command.seconds->count() == 0) command.rig.seconds = drawn.frames / command.rig.fps;
}

Status run_simulate(SimulateCommand command) {
  StopOnSignal stop;
  command.rig.sensing.camera = *simulator::camera_model_named(command.camera);
  command.rig.timing.lost_share = 0.01 * command.lost_percent;
  if (!command.harsh.empty()) {
    command.rig.sensing.harsh = *simulator::harshness_named(command.harsh);
    if (command.mutual->count() == 0) command.rig.sensing.mutual_interference = true;
    draw_length(command);
  }
  if (command.clean) command.rig.clean();
  // Known at once, not only when the first frames are ready.
  std::error_code error;
  const bool is_new = !std::filesystem::exists(command.out, error);
  if (auto status = recording::make_empty_folder(command.out); !status) return status;
  StatusLine line;
  const Status simulated = simulator::simulate_rig(
      command.out, command.rig,
      [&line](const simulator::SimulateProgress& progress) {
        line.show_progress(progress.doing, progress.done, progress.total);
      },
      stop.token());
  if (!simulated && is_new) std::filesystem::remove(command.out, error);  // only if it is empty
  return simulated;
}

void add_room_options(CLI::App& command, SimulateCommand& values) {
  command.add_option("--scene", values.rig.scene, "Scene: " + simulator::scene_list());
  command.add_option("--sensors", values.rig.sensor_count, "Number of sensors around the room")
      ->check(within(1, 8))
      ->capture_default_str();
  values.seconds = command.add_option("--seconds", values.rig.seconds, "Length")
                       ->check(some_seconds())
                       ->capture_default_str();
  values.fps = command.add_option("--fps", values.rig.fps, "Frames per second")
                   ->check(within(1.0, simulator::kMaxSimulatedFps))
                   ->capture_default_str();
  command.add_option("--seed", values.rig.seed, "Seed of noise, devices and appearance")
      ->check(seed_number())
      ->capture_default_str();
  command.add_option("--speed", values.rig.speed, "Speed of all motion: 1 is natural, 0 is none")
      ->check(within(0.0, simulator::kMaxSimulatedSpeed))
      ->capture_default_str();
}

void add_sensor_options(CLI::App& command, SimulateCommand& values) {
  command.add_option("--camera", values.camera, "Camera type: kinect2, azure or d435")
      ->check(CLI::IsMember({"kinect2", "azure", "d435"}))
      ->capture_default_str();
  command.add_flag("--half-color", values.rig.sensing.half_color, "Colour of 960x540");
  command
      .add_option("--clock-offset", values.rig.timing.clock_offset_s,
                  "Maximum offset of the sensors' clocks in seconds")
      ->check(within(0.0, 1000.0))
      ->capture_default_str();
  command
      .add_option("--clock-drift", values.rig.timing.rate_ppm,
                  "Maximum error of the frame rates in ppm")
      ->check(within(0.0, 1000.0))
      ->capture_default_str();
  command.add_option("--drops", values.lost_percent, "Percentage of lost frames")
      ->check(within(0.0, 50.0))
      ->capture_default_str();
  command
      .add_option("--interference", values.rig.sensing.interference_per_minute,
                  "Bursts of infrared interference per minute and sensor")
      ->check(within(0.0, simulator::kMaxInterferencePerMinute))
      ->capture_default_str();
  values.mutual = command.add_flag(
      "--mutual-interference,!--no-mutual-interference", values.rig.sensing.mutual_interference,
      "The sensors' infrared light disturbs the other sensors; with --harsh unless switched off");
  command
      .add_flag("--harsh{mixed}", values.harsh,
                "Uncalibrated sensors as found in the field, drawn at random: noise, wrong lenses "
                "and scales, drifting colour, motion blur, a few frames; --harsh=tof or "
                "--harsh=structured for one kind")
      ->check(CLI::IsMember({"tof", "structured", "mixed"}))
      ->excludes("--camera");
  command.add_flag("--clean", values.clean, "Perfect sensors: no errors of any kind")
      ->excludes("--harsh");
}

void add_truth_options(CLI::App& command, SimulateCommand& values) {
  command.add_flag("--truth-color", values.rig.truth_color,
                   "Write noise-free colour into truth/, too");
  command.add_option("--views", values.rig.views, "Number of free viewpoints in truth/")
      ->check(within(0, simulator::kMaxSimulatedViews))
      ->capture_default_str();
  command.add_option("--view-size", values.rig.view_side_px, "Their width and height in pixels")
      ->check(within(16, simulator::kMaxSimulatedViewSide))
      ->capture_default_str();
  command.add_option("--threads", values.rig.threads, "Threads; 0: one per core")
      ->check(within(0, 64))
      ->capture_default_str();
}

}  // namespace

void add_simulate_command(CLI::App& app, Command& chosen) {
  auto values = std::make_shared<SimulateCommand>();
  CLI::App* command =
      app.add_subcommand("simulate", "Write a recording of a simulated room with its truth");
  command->add_option("out", values->out, "New folder")->required();
  add_room_options(*command, *values);
  add_sensor_options(*command, *values);
  add_truth_options(*command, *values);
  command->footer(
      "Writes a rig and its truth in OUT/truth: docs/simulator.md.\n"
      "The same options give the same files on any number of threads.\n"
      "Example:\n"
      "  roomcast simulate recordings/office --scene office --sensors 3 --seconds 5 --seed 7");
  command->callback([values, &chosen] {
    chosen = [values] { return finish("simulate", run_simulate(*values)); };
  });
}

}  // namespace roomcast::cli
