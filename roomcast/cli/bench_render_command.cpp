// SPDX-License-Identifier: Apache-2.0
// roomcast bench render: image quality from viewpoints without a sensor, and the cost of drawing.
#include <iostream>
#include <memory>
#include <string>

#include "bench/render/render_bench.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/number_option.h"
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
      "render", "Errors of free-viewpoint pictures against the truth, and the cost of drawing");
  command->add_option("rig", options->rig, "A rig with true views (simulate --views writes them)")
      ->required();
  add_view_modes_option(*command, "--mode", options->modes);
  command
      ->add_option("--color-scale", options->color_scale,
                   "Colour pixels per depth pixel in each direction, as in roomcast sensor")
      ->check(within(1, 2));
  command->add_option("--aligned", options->aligned,
                      "Use the poses of this report of `roomcast align RIG --json`");
  command
      ->add_option("--pose-error-mm", options->pose_error_mm, "Shift every sensor by this distance")
      ->check(within(0.0, 1000.0));
  command
      ->add_option("--pose-error-deg", options->pose_error_deg, "Turn every sensor by this angle")
      ->check(within(0.0, 180.0));
  command->add_option("--pose-seed", options->pose_seed, "Seed of these directions")
      ->check(seed_number());
  command
      ->add_option("--late-ms", options->late_ms,
                   "The last sensor's pictures are this old, as over a slow line")
      ->check(within(0.0, 10'000.0));
  command->add_flag("--as-seen{false}", options->one_instant,
                    "Draw what moves where each sensor saw it, not where it is at one instant");
  command->add_flag("--keep-late", options->keep_late,
                    "Draw these old pictures whole, also where others see through them");
  command->add_flag("--keep-holes{false}", options->fill_holes,
                    "Leave depth as recorded, as roomcast sensor --keep-holes");
  command->add_flag("--model", options->model,
                    "Show the model of what stands still where no sensor shows anything");
  command->add_option("--pictures", options->pictures,
                      "Write the pictures into this folder, and where people are missing (red) or "
                      "doubled (blue)");
  command->add_flag("--stereo", options->stereo,
                    "Also compare drawing both eyes in one pass with one after the other");
  command->add_flag("--json", *json, "Print JSON");
  command->footer(
      "Example:\n  roomcast simulate room --scene lab --sensors 3 --seconds 3 --views 4\n"
      "  roomcast bench render room --mode points,mesh,blend --pictures drawn");
  command->callback([options, json, &chosen] {
    chosen = [options, json] { return finish("bench render", run_render(*options, *json)); };
  });
}

}  // namespace roomcast::cli
