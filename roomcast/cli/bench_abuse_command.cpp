// SPDX-License-Identifier: Apache-2.0
// roomcast bench abuse: the effect of attacks on a hub on the clients of its rooms.
#include <chrono>
#include <iostream>
#include <memory>

#include "bench/abuse/abuse_bench.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/status_line.h"

namespace roomcast::cli {
namespace {

Status run_abuse(const bench::AbuseBenchOptions& options, bool json) {
  StatusLine line;
  const auto rows =
      bench::run_abuse_bench(options, [&line](const std::string& next) { line.show(next); });
  if (!rows) return rows.error();
  json ? bench::print_json(*rows, std::cout) : bench::print_table(*rows, std::cout);
  return {};
}

}  // namespace

void add_abuse_bench(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<bench::AbuseBenchOptions>();
  auto json = std::make_shared<bool>(false);
  auto seconds = std::make_shared<double>(std::chrono::duration<double>(options->duration).count());
  CLI::App* command = bench.add_subcommand(
      "abuse", "Effect of half-open, invalid and slow connections and bad tokens on other clients");
  command->add_option("--viewers", options->viewers, "Viewers in the room")
      ->check(within(1, 200))
      ->capture_default_str();
  command
      ->add_option("--rounds", options->rounds, "Rounds; each measures without and with an attack")
      ->check(within(1, 100))
      ->capture_default_str();
  command
      ->add_option("--connections", options->connections,
                   "Simultaneous connections of one attacker")
      ->check(within(1, 10'000))
      ->capture_default_str();
  command
      ->add_option("--bad-tokens", options->bad_tokens,
                   "Invalid tokens sent in all rounds together")
      ->check(within(1, 1'000'000))
      ->capture_default_str();
  command->add_option("--seconds", *seconds, "Seconds per measurement")
      ->check(within(0.2, 60.0))
      ->capture_default_str();
  command->add_flag("--json", *json, "Print JSON");
  command->footer("Example:\n  roomcast bench abuse --rounds 5");
  command->callback([options, seconds, json, &chosen] {
    options->duration =
        std::chrono::round<std::chrono::milliseconds>(std::chrono::duration<double>(*seconds));
    chosen = [options, json] { return finish("bench abuse", run_abuse(*options, *json)); };
  });
}

}  // namespace roomcast::cli
