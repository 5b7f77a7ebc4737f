// SPDX-License-Identifier: Apache-2.0
// roomcast bench render: image quality from viewpoints without a sensor, and the cost of drawing.
#include <iostream>
#include <memory>
#include <string>

#include "bench/render/render_bench.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/render_mode_option.h"
#include "roomcast/cli/status_line.h"

namespace roomcast::cli {
namespace {

Status run_render(const bench::RenderBenchOptions& options, bool json) {
  StatusLine line;
  const auto report =
      bench::run_render_bench(options, [&line](const std::string& next) { line.show(next); });
  if (!report) return report.error();
  json ? bench::print_json(*report, std::cout) : bench::print_table(*report, std::cout);
  return {};
}

}  // namespace

void add_render_bench(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<bench::RenderBenchOptions>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand(
      "render", "Pictures from where no sensor stood, beside the truth; and what drawing costs");
  command->add_option("rig", options->rig, "A rig with true views (simulate --views writes them)")
      ->required();
  add_modes_option(*command, "--mode", options->modes);
  command
      ->add_option("--color-scale", options->color_scale,
                   "Colour pixels for each pixel of depth and direction, as of roomcast sensor")
      ->check(CLI::Range(1, 2));
  command->add_option("--aligned", options->aligned,
                      "Draws with the poses of this report of `roomcast align RIG --json`");
  command->add_option("--pose-error-mm", options->pose_error_mm, "Moves every sensor so far")
      ->check(CLI::Range(0.0, 1000.0));
  command->add_option("--pose-error-deg", options->pose_error_deg, "Turns every sensor so much")
      ->check(CLI::Range(0.0, 180.0));
  command->add_option("--pose-seed", options->pose_seed, "Whereto");
  command->add_option("--pictures", options->pictures, "Writes what was drawn into this folder");
  command->add_flag("--stereo", options->stereo,
                    "Also what two eyes drawn at once cost beside one drawn after the other");
  command->add_flag("--json", *json, "For scripts");
  command->footer(
      "Example:\n  roomcast simulate room --scene lab --sensors 3 --seconds 3 --views 4\n"
      "  roomcast bench render room --mode points,mesh,blend --pictures drawn");
  command->callback([options, json, &chosen] {
    chosen = [options, json] { return finish("bench render", run_render(*options, *json)); };
  });
}

}  // namespace roomcast::cli
