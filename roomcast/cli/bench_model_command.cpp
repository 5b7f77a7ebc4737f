// SPDX-License-Identifier: Apache-2.0
// roomcast bench model: the fused model of rigs, compared with the truth.
#include <iostream>
#include <memory>
#include <string>

#include "bench/model/model_bench.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/status_line.h"

namespace roomcast::cli {
namespace {

Status run_model(const bench::ModelBenchOptions& options, bool json) {
  StatusLine line;
  const auto rows =
      bench::run_model_bench(options, [&line](const std::string& next) { line.show(next); });
  if (!rows) return rows.error();
  json ? bench::print_json(*rows, std::cout) : bench::print_table(*rows, std::cout);
  return {};
}

}  // namespace

void add_model_bench(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<bench::ModelBenchOptions>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand(
      "model", "Errors, coverage, memory and time of the model fused from a rig's still surfaces");
  command->add_option("rigs", options->rigs, "Rigs with truth (roomcast simulate writes them)")
      ->required();
  command->add_option("--voxel", options->model.voxel_m, "Size of the model's cells (metres)")
      ->check(within(model::kMinVoxel_m, model::kMaxVoxel_m))
      ->capture_default_str();
  command->add_option("--kept", options->kept,
                      "Look at this model of a running room that played the rig: the answer of "
                      "GET /api/v1/rooms/ROOM/model");
  command->add_flag("--compressed", options->compressed,
                    "Look at the mesh as a room.draco.glb has it");
  command->add_option("--pictures", options->pictures,
                      "Write pictures of the errors into this folder: red nothing, blue elsewhere, "
                      "yellow in front");
  command->add_flag("--json", *json, "Print JSON");
  command->footer(
      "Example:\n  roomcast simulate room --scene lab --sensors 3 --seconds 1\n"
      "  roomcast bench model room");
  command->callback([options, json, &chosen] {
    chosen = [options, json] { return finish("bench model", run_model(*options, *json)); };
  });
}

}  // namespace roomcast::cli
