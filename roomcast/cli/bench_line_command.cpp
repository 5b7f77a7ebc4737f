// SPDX-License-Identifier: Apache-2.0
// roomcast bench line: what the sensors of a room cost on their line.
#include <iostream>
#include <memory>

#include "bench/line/line_bench.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/status_line.h"

namespace roomcast::cli {
namespace {

Status run_line(const bench::LineBenchOptions& options, bool json) {
  StatusLine line;
  const auto report =
      bench::run_line_bench(options, [&line](const std::string& next) { line.show(next); });
  if (!report) return report.error();
  json ? bench::print_json(*report, std::cout) : bench::print_table(*report, std::cout);
  return {};
}

}  // namespace

void add_line_bench(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<bench::LineBenchOptions>();
  auto seconds = std::make_shared<double>(10);
  auto json = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand("line",
                                           "What a room's sensors cost on their line: unwatched, "
                                           "with a viewer who looks around, with a target rate, "
                                           "and on a line that changes");
  command
      ->add_option(
          "--case", options->cases,
          "Cases: unwatched, looking, rate, uplink, auto, late, viewer, loss (the last six need "
          "root)")
      ->delimiter(',')
      ->check(CLI::IsMember(
          {"unwatched", "looking", "rate", "uplink", "auto", "late", "viewer", "loss"}));
  command
      ->add_option(
          "--mbit", options->target_mbit,
          "Cases rate, uplink: target rates of all sensors together; case viewer: rates of "
          "a viewer's line, Mbit/s")
      ->delimiter(',')
      ->check(within(0.1, 800.0));
  command
      ->add_option("--link-mbit", options->link_mbit,
                   "Case auto: rates of the link, one after the other, Mbit/s (default: 8,2,8)")
      ->delimiter(',')
      ->check(within(0.1, 1'000.0));
  command
      ->add_option(
          "--path", options->viewer_path,
          "Case looking: how a viewer's head moved, a text file of poses as Unity has them "
          "(default: a walk round the room)")
      ->check(CLI::ExistingFile);
  command->add_option("--scene", options->scene, "The simulated room")->capture_default_str();
  command->add_option("--sensors", options->sensors, "Number of simulated sensors")
      ->check(within(1, 8))
      ->capture_default_str();
  command->add_option("--seconds", *seconds, "Seconds per measurement")
      ->check(within(1.0, 600.0))
      ->capture_default_str();
  command->add_flag("--json", *json, "Print JSON");
  command->footer("Example:\n  roomcast bench line --case unwatched,rate --seconds 20");
  command->callback([options, seconds, json, &chosen] {
    options->duration = std::chrono::milliseconds(static_cast<std::int64_t>(*seconds * 1000));
    chosen = [options, json] { return finish("bench line", run_line(*options, *json)); };
  });
}

}  // namespace roomcast::cli
