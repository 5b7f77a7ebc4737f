// SPDX-License-Identifier: Apache-2.0
// roomcast bench: the measurements behind the README's table.
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/codec/codec_bench.h"
#include "bench/codec/curves/curve_choices.h"
#include "bench/codec/curves/rate_chart.h"
#include "bench/codec/filtered_input.h"
#include "bench/register_bench.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/command.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/io/file_bytes.h"

namespace roomcast::cli {
namespace {

struct CodecCommandOptions {
  std::string input = "sim:studio";
  bench::BenchInputOptions simulator;
  bench::CodecBenchOptions bench;
  std::string curves;  // a file; empty: the usual table
  bool filtered = false;
  bool json = false;
};

Status run_codec(const CodecCommandOptions& options) {
  auto input = bench::open_bench_input(options.input, options.simulator);
  if (!input) return input.error();
  if (options.filtered) *input = bench::without_interference(*std::move(input));
  bench::CodecBenchOptions what = options.bench;
  if (!options.curves.empty()) what.choices = bench::curve_choices();
  StatusLine line;
  const auto report = bench::run_codec_bench(
      **input, what, [&line](int frame) { line.show(fmt::format("frame {}", frame)); });
  if (!report) return report.error();
  if (!options.curves.empty()) {
    const std::string caption =
        fmt::format("{}{}, {}x{} at {:g} frames/s, {} frames",
                    report->input.starts_with("sim") ? "Simulated: " : "", report->input,
                    report->width, report->height, report->fps, report->measured_frames);
    if (Status written =
            io::write_file(options.curves, bench::rate_chart(bench::rate_panels(*report), caption));
        !written) {
      return written;
    }
  }
  options.json ? bench::print_json(*report, std::cout) : bench::print_table(*report, std::cout);
  return {};
}

void add_codec_bench(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<CodecCommandOptions>();
  CLI::App* command = bench.add_subcommand(
      "codec", "Bytes, CPU time and errors of every codec and of its peers on one sensor's frames");
  command
      ->add_option("input", options->input,
                   "rig:DIR#s0, tum:DIR, a folder (of a rig the first sensor), sim[:scene][#n]")
      ->capture_default_str();
  CLI::Option* only =
      command->add_option("--codec,--mode", options->bench.only,
                          "Only this codec, or modes that begin like this: roomcast, lossless");
  command->add_option("--frames", options->bench.most_frames, "Maximum number of frames")
      ->check(within(1, 10'000))
      ->capture_default_str();
  command
      ->add_option("--warmup", options->bench.warm_up_s,
                   "Seconds at the start that are not measured (at most a third)")
      ->check(within(0.0, 60.0))
      ->capture_default_str();
  command->add_option("--key-every", options->bench.key_every_s, "Seconds between key frames")
      ->check(within(0.1, 3600.0))
      ->capture_default_str();
  command
      ->add_option("--color-kbit", options->bench.color_kbit_per_s,
                   "Bit rate of colour where there is rate control, kbit/s")
      ->check(within(50, 20'000))
      ->capture_default_str();
  CLI::Option* targets = command
                             ->add_option("--mbit", options->bench.target_mbit,
                                          "Adds rows with these target rates of a sensor, Mbit/s")
                             ->delimiter(',')
                             ->check(within(0.1, 100.0));
  command
      ->add_option("--curves", options->curves,
                   "Measure each codec at several qualities, and draw errors over Mbit/s into this "
                   "file (SVG)")
      ->excludes(only)
      ->excludes(targets);
  command
      ->add_option("--fps", options->simulator.sim_fps, "Frames per second of a simulated sensor")
      ->check(within(1.0, 60.0))
      ->capture_default_str();
  command
      ->add_option("--speed", options->simulator.sim_speed,
                   "Speed of motion in a simulated room: 1 is real time")
      ->check(within(0.0, 10.0))
      ->capture_default_str();
  command
      ->add_option("--back-and-forth", options->simulator.back_and_forth_fps,
                   "Play a recording forward and backward at this many frames per second, until "
                   "--frames; also measures depth errors on what stands still")
      ->check(within(1.0, 60.0));
  command->add_flag(
      "--filter-interference", options->filtered,
      "Remove what the infrared light of other cameras does to depth, as a sensor does");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Example:\n  roomcast bench codec rig:recordings/lab#s0 --json\n"
      "  roomcast bench codec sim:studio --fps 15 --frames 120 --curves curves.svg");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("bench codec", run_codec(*options)); };
  });
}

Status run_register(const std::string& source, bool json) {
  std::vector<bench::RegisterBenchInput> inputs = {bench::synthetic_kinect_v2_input()};
  if (!source.empty()) {
    constexpr int kMaxFrames = 10;
    auto recorded = bench::recorded_input(source, kMaxFrames);
    if (!recorded) return recorded.error();
    inputs.push_back(std::move(*recorded));
  }
  const auto report = bench::run_register_bench(inputs);
  if (!report) return report.error();
  json ? bench::print_json(*report, std::cout) : bench::print_table(*report, std::cout);
  return {};
}

void add_register_bench(CLI::App& bench, Command& chosen) {
  auto source = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand(
      "register", "Registration of colour to depth: frames per second on one core");
  command->add_option("source", *source,
                      "Measure this recording too: rig:DIR#s0, tum:DIR (Kinect v2 sizes)");
  command->add_flag("--json", *json, "Print JSON");
  command->footer("Example:\n  roomcast bench register rig:recordings/lab#s0 --json");
  command->callback([source, json, &chosen] {
    chosen = [source, json] { return finish("bench register", run_register(*source, *json)); };
  });
}

}  // namespace

void add_bench_command(CLI::App& app, Command& chosen) {
  CLI::App* bench = app.add_subcommand("bench", "Measure parts of roomcast on this machine");
  bench->require_subcommand(1);
  bench->footer("Example: roomcast bench register");
  add_codec_bench(*bench, chosen);
  add_register_bench(*bench, chosen);
  add_align_bench(*bench, chosen);
  add_fanout_bench(*bench, chosen);
  add_frame_times_bench(*bench, chosen);
  add_abuse_bench(*bench, chosen);
  add_latency_bench(*bench, chosen);
  add_line_bench(*bench, chosen);
  add_model_bench(*bench, chosen);
  add_moved_furniture_bench(*bench, chosen);
  add_real_bench(*bench, chosen);
  add_redundancy_bench(*bench, chosen);
  add_render_bench(*bench, chosen);
}

}  // namespace roomcast::cli
