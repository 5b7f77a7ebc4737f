// SPDX-License-Identifier: Apache-2.0
// roomcast bench frame-times: how long pictures for two eyes take, by number of sensors.
#include <iostream>
#include <memory>
#include <string>

#include "bench/render/frame_times.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/render_mode_option.h"
#include "roomcast/cli/status_line.h"

namespace roomcast::cli {
namespace {

Status run_times(const bench::FrameTimesOptions& options, bool json) {
  StatusLine line;
  const auto report =
      bench::run_frame_times(options, [&line](const std::string& next) { line.show(next); });
  if (!report) return report.error();
  json ? bench::print_json(*report, std::cout) : bench::print_table(*report, std::cout);
  return {};
}

}  // namespace

void add_frame_times_bench(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<bench::FrameTimesOptions>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand(
      "frame-times", "Time until a picture for two eyes is finished, by number of sensors");
  command->add_option("rig", options->rig, "A rig with true views (simulate --views writes them)")
      ->required();
  add_modes_option(*command, "--mode", options->modes);
  command
      ->add_option("--sensors", options->sensors,
                   "Numbers of sensors; beyond the rig's, copies stand beside them")
      ->delimiter(',')
      ->check(within(1, 64))
      ->capture_default_str();
  command->add_option("--eye-pixels", options->eye_pixels, "Width and height for each eye")
      ->check(within(16, 4096))
      ->capture_default_str();
  command
      ->add_option("--frame-sets", options->frame_sets,
                   "Frame sets that are drawn, three times each")
      ->check(within(1, 10'000))
      ->capture_default_str();
  command->add_flag("--json", *json, "Print JSON");
  command->footer(
      "Times are of the driver it runs on: a graphics card's if there is one.\nExample:\n"
      "  roomcast simulate room --scene meeting --sensors 8 --seconds 0.4\n"
      "  roomcast bench frame-times room --mode blend --sensors 4,8,16");
  command->callback([options, json, &chosen] {
    chosen = [options, json] { return finish("bench frame-times", run_times(*options, *json)); };
  });
}

}  // namespace roomcast::cli
