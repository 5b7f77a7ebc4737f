// SPDX-License-Identifier: Apache-2.0
// roomcast bench align: alignment methods side by side on recordings with known poses.
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "bench/align/align_bench.h"
#include "roomcast/align/pair/free_space.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/command.h"
#include "roomcast/cli/recorded_views.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/source/rig_json.h"

namespace roomcast::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPairList = "alignment_pairs.json";
constexpr std::size_t kOverlapPoints = 4000;

/// All pairs of a rig that knows where its sensors stand. The overlap is what both views show of
/// each other at the true pose.
Result<bench::AlignInput> read_rig_input(const fs::path& folder, const ReadProgress& progress) {
  const auto rig = read_rig_json(folder / "rig.json");
  if (!rig) return rig.error();
  const auto bundles = read_rig_bundles(folder, progress);
  if (!bundles) return bundles.error();
  bench::AlignInput input;
  input.name = folder.filename().string();
  input.whole_rig = true;
  std::vector<RigidTransform> world_from_depth;
  for (std::size_t i = 0; i < bundles->size(); ++i) {
    const auto& truth = rig->sensors[i].world_from_depth;
    const auto view = view_of((*bundles)[i]);
    if (!truth || !view) continue;
    input.views.push_back(*view);
    world_from_depth.push_back(*truth);
  }
  for (std::size_t a = 0; a < input.views.size(); ++a) {
    for (std::size_t b = a + 1; b < input.views.size(); ++b) {
      const RigidTransform a_from_b = world_from_depth[a].inverse() * world_from_depth[b];
      const auto check = align::check_free_space(input.views[a]->surface, input.views[b]->surface,
                                                 a_from_b, kOverlapPoints);
      input.cases.push_back({a, b, a_from_b, check.consistent_least});
    }
  }
  return input;
}

Result<bench::AlignInput> read_pairs_input(const fs::path& folder, const ReadProgress& progress) {
  const auto pairs = read_pair_list(folder / kPairList);
  if (!pairs) return pairs.error();
  auto frames = FrameViews::read(folder, *pairs, progress);
  if (!frames) return frames.error();
  bench::AlignInput input;
  input.name = folder.filename().string();
  for (const ListedPair& pair : *pairs) {
    const auto& a = frames->at(pair.a);
    const auto& b = frames->at(pair.b);
    if (!a || !b || !pair.b_from_a || !pair.overlap) continue;
    input.views.push_back(*a);
    input.views.push_back(*b);
    input.cases.push_back(
        {input.views.size() - 2, input.views.size() - 1, pair.b_from_a->inverse(), *pair.overlap});
  }
  return input;
}

Status run_bench(const std::vector<std::string>& folders, bool json) {
  StatusLine line;
  const auto show = [&](std::string_view what) { line.show(what); };
  std::vector<bench::AlignInput> inputs;
  for (const std::string& name : folders) {
    const fs::path folder = fs::path(name).lexically_normal();
    std::error_code ignored;
    auto input = fs::exists(folder / "rig.json", ignored) ? read_rig_input(folder, show)
                                                          : read_pairs_input(folder, show);
    if (!input) return input.error();
    inputs.push_back(std::move(*input));
  }
  const auto rows = bench::run_align_bench(inputs, show);
  json ? bench::print_json(rows, std::cout) : bench::print_table(rows, std::cout);
  return {};
}

}  // namespace

void add_align_bench(CLI::App& bench, Command& chosen) {
  auto folders = std::make_shared<std::vector<std::string>>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand(
      "align", "Alignment methods side by side on recordings with known poses");
  command
      ->add_option("recordings", *folders,
                   "Rigs with poses, or TUM recordings with alignment_pairs.json")
      ->required();
  command->add_flag("--json", *json, "For scripts");
  command->footer("Example:\n  roomcast bench align recordings/lab recordings/kitchen --json");
  command->callback([folders, json, &chosen] {
    chosen = [folders, json] { return finish("bench align", run_bench(*folders, *json)); };
  });
}

}  // namespace roomcast::cli
