// SPDX-License-Identifier: Apache-2.0
// roomcast bench redundancy: what the sensors of a rig send although another one shows it better.
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "bench/redundancy/redundancy_bench.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/status_line.h"

namespace roomcast::cli {
namespace {

struct RedundancyCommandOptions {
  std::vector<std::string> rigs;
  bench::RedundancyOptions bench;
  bool json = false;
};

Result<std::vector<bench::RedundancyReport>> measure_redundancy(
    const RedundancyCommandOptions& options) {
  std::vector<bench::RedundancyReport> reports;
  StatusLine line;
  for (const std::string& folder : options.rigs) {
    const auto rig = recording::read_rig_json(std::filesystem::path(folder) / "rig.json");
    if (!rig) return rig.error();
    for (const recording::RigSensorEntry& sensor : rig->sensors) {
      if (sensor.world_from_depth) continue;
      return invalid_argument(
          "sensor " + sensor.id + " of " + folder +
          " has no pose: write poses into a copy (roomcast align COPY --write)");
    }
    auto report = bench::run_redundancy_bench(
        folder, *rig, options.bench,
        [&](const std::string& what) { line.show(folder + ": " + what); });
    if (!report) return report.error();
    reports.push_back(*std::move(report));
  }
  return reports;
}

Status run_redundancy(const RedundancyCommandOptions& options) {
  const auto reports = measure_redundancy(options);
  if (!reports) return reports.error();
  if (options.json) {
    bench::print_json(*reports, std::cout);
    return {};
  }
  for (const bench::RedundancyReport& report : *reports) bench::print_table(report, std::cout);
  return {};
}

}  // namespace

void add_redundancy_bench(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<RedundancyCommandOptions>();
  CLI::App* command = bench.add_subcommand(
      "redundancy", "What a rig's sensors send although another of them shows it better");
  command->add_option("rigs", options->rigs, "Folders with a rig.json that has poses")->required();
  command
      ->add_option("--frames", options->bench.frames,
                   "Frames of each sensor, played forward and backward (default: once)")
      ->check(within(1, 10'000));
  command->add_option("--key-seconds", options->bench.key_interval_s, "Time between key frames")
      ->check(within(0.1, 3'600.0))
      ->capture_default_str();
  command
      ->add_option("--better", options->bench.better.better,
                   "By how many times the pixels another sensor must show a surface")
      ->check(within(1.0, 100.0))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON");
  command->footer("Example:\n  roomcast bench redundancy recordings/house3 --frames 150");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("bench redundancy", run_redundancy(*options)); };
  });
}

}  // namespace roomcast::cli
