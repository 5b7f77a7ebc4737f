// SPDX-License-Identifier: Apache-2.0
// roomcast bench fanout: compares the hub with a minimal socket server and with message brokers.
#include <chrono>
#include <iostream>
#include <memory>

#include "bench/fanout/fanout_bench.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/status_line.h"

namespace roomcast::cli {
namespace {

Status run_fanout(const bench::FanoutBenchOptions& options, bool json) {
  StatusLine line;
  const auto report =
      bench::run_fanout_bench(options, [&line](const std::string& next) { line.show(next); });
  if (!report) return report.error();
  json ? bench::print_json(*report, std::cout) : bench::print_table(*report, std::cout);
  return {};
}

}  // namespace

void add_fanout_bench(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<bench::FanoutBenchOptions>();
  auto json = std::make_shared<bool>(false);
  auto seconds = std::make_shared<double>(std::chrono::duration<double>(options->duration).count());
  CLI::App* command = bench.add_subcommand(
      "fanout", "One frame to many viewers: CPU time and delay of the hub and of message brokers");
  command->add_option("--viewers", options->viewers, "Numbers of viewers at full speed")
      ->delimiter(',')
      ->check(within(1, 2048))
      ->capture_default_str();
  command->add_option("--rounds", options->rounds, "Measurements of each server, in turns")
      ->check(within(1, 100))
      ->capture_default_str();
  command->add_option("--load", options->loads, "Loads: max, room, stall, heads, elsewhere")
      ->delimiter(',')
      ->check(CLI::IsMember({"max", "room", "stall", "heads", "elsewhere"}));
  command
      ->add_option("--only", options->only, "Only servers with one of these texts in their names")
      ->delimiter(',');
  command
      ->add_option("--seconds", *seconds,
                   "Seconds per measurement at full speed; others take twice as long")
      ->check(within(0.1, 6.0))
      ->capture_default_str();
  command->add_flag("--json", *json, "Print JSON");
  command->footer(
      "Example:\n  roomcast bench fanout --viewers 100,500 --rounds 5\n"
      "nats-server, redis-server and mosquitto are measured too where they are installed.");
  command->callback([options, seconds, json, &chosen] {
    options->duration =
        std::chrono::round<std::chrono::milliseconds>(std::chrono::duration<double>(*seconds));
    chosen = [options, json] { return finish("bench fanout", run_fanout(*options, *json)); };
  });
}

}  // namespace roomcast::cli
