// SPDX-License-Identifier: Apache-2.0
// roomcast bench latency: end-to-end latency on this machine and over emulated bad networks.
#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "bench/latency/clock_sensors.h"
#include "bench/latency/latency_bench.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/core/interruptible_wait.h"

namespace roomcast::cli {
namespace {

Status run_latency(const bench::LatencyBenchOptions& options, bool json) {
  StatusLine line;
  const auto report =
      bench::run_latency_bench(options, [&line](const std::string& next) { line.show(next); });
  if (!report) return report.error();
  json ? bench::print_json(*report, std::cout) : bench::print_table(*report, std::cout);
  return {};
}

/// Until it is interrupted.
Status run_clock_sensors(const std::string& hub_url) {
  StopOnSignal stop;
  const auto sensors = bench::start_clock_sensors(hub_url);
  if (!sensors) return sensors.error();
  print_out("{}\n", bench::clock_view_json(sensors->front()->description()));
  std::fflush(stdout);
  while (wait_for(std::chrono::hours(1), stop.token())) {
  }
  return {};
}

}  // namespace

void add_latency_bench(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<bench::LatencyBenchOptions>();
  auto seconds = std::make_shared<double>(10);
  auto json = std::make_shared<bool>(false);
  auto clock_hub = std::make_shared<std::string>();
  CLI::App* command = bench.add_subcommand("latency",
                                           "Latency from capture to decoded frame and to the "
                                           "window's pixels, also over emulated bad networks "
                                           "(needs root)");
  command->add_option("--case", options->cases, "Cases: room, glass, internet, narrow, voice")
      ->delimiter(',')
      ->check(CLI::IsMember({"room", "glass", "internet", "narrow", "voice"}));
  command->add_option("--seconds", *seconds, "Seconds per case")
      ->check(within(1.0, 600.0))
      ->capture_default_str();
  command->add_option(
      "--clock-sensors", *clock_hub,
      "Instead: send simulated sensors to this hub, one of which draws the time of capture, until "
      "interrupted; tests/e2e/glass.test.mjs reads it back");
  command->add_flag("--json", *json, "Print JSON");
  command->footer("Example:\n  roomcast bench latency --case internet,narrow --seconds 30");
  command->callback([options, seconds, json, clock_hub, &chosen] {
    options->duration = std::chrono::milliseconds(static_cast<std::int64_t>(*seconds * 1000));
    chosen = [options, json, clock_hub] {
      return finish("bench latency", clock_hub->empty() ? run_latency(*options, *json)
                                                        : run_clock_sensors(*clock_hub));
    };
  });
}

}  // namespace roomcast::cli
