// SPDX-License-Identifier: Apache-2.0
// roomcast bench real: alignment, bytes, and views with one sensor left out, of real rigs.
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "bench/real/real_bench.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/recording/align/recorded_alignment.h"

namespace roomcast::cli {
namespace {

struct RealCommandOptions {
  std::vector<std::string> rigs;
  std::string page;  // a folder; empty: none
  bench::RealBenchOptions bench;
  bool json = false;
};

Result<std::vector<bench::RealReport>> measure(const RealCommandOptions& options) {
  std::vector<bench::RealReport> reports;
  StatusLine line;
  for (const std::string& rig : options.rigs) {
    const auto show = [&](const std::string& what) { line.show(rig + ": " + what); };
    const auto alignment =
        recording::align_recording(rig, "auto", {}, show, alignment::DepthScaling::kEstimated);
    if (!alignment) return alignment.error();
    auto report = bench::run_real_bench(rig, *alignment, options.bench, show);
    if (!report) return report.error();
    reports.push_back(*std::move(report));
  }
  return reports;
}

Status run_real(const RealCommandOptions& options) {
  const auto reports = measure(options);
  if (!reports) return reports.error();
  if (!options.page.empty()) {
    if (auto status = bench::write_page(*reports, options.page); !status) return status;
  }
  if (options.json) {
    bench::print_json(*reports, std::cout);
    return {};
  }
  for (const bench::RealReport& report : *reports) bench::print_table(report, std::cout);
  return {};
}

}  // namespace

void add_real_bench(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<RealCommandOptions>();
  CLI::App* command = bench.add_subcommand(
      "real", "Poses, bytes, and each sensor drawn from the others, on recordings without truth");
  command->add_option("rigs", options->rigs, "Folders with a rig.json and at least two sensors")
      ->required();
  command->add_option("--page", options->page,
                      "Write a web page with figures and pictures into this folder");
  command
      ->add_option("--pictures", options->bench.left_out_pictures,
                   "Pictures of each sensor drawn from the others; 0: none")
      ->check(within(0, 1000))
      ->capture_default_str();
  command
      ->add_option("--frames", options->bench.codec_frames,
                   "Maximum number of frames of each sensor for codecs; 0: no codecs")
      ->check(within(0, 10'000))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON");
  command->footer("Example:\n  roomcast bench real recordings/lab --page lab-report");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("bench real", run_real(*options)); };
  });
}

}  // namespace roomcast::cli
