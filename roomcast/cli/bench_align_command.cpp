// SPDX-License-Identifier: Apache-2.0
// roomcast bench align: compares alignment methods on recordings with known poses.
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "bench/align/align_bench.h"
#include "bench/align/corners_suite.h"
#include "bench/align/frames_suite.h"
#include "bench/align/fresh_suite.h"
#include "bench/align/harsh_suite.h"
#include "bench/align/join_suite.h"
#include "bench/live_align/board_suite.h"
#include "bench/live_align/moved_suite.h"
#include "bench/live_align/person_suite.h"
#include "roomcast/alignment/pair/free_space.h"
#include "roomcast/cli/bench_commands.h"
#include "roomcast/cli/command.h"
#include "roomcast/cli/frames_rig.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/recording/align/recorded_views.h"
#include "roomcast/recording/dataset/rig_json.h"
#include "roomcast/simulator/scene/room.h"

namespace roomcast::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPairList = "alignment_pairs.json";
constexpr std::size_t kOverlapPoints = 4000;

/// All pairs of a rig with known poses. The overlap is measured in both directions at the true
/// pose.
Result<bench::AlignInput> read_rig_input(const fs::path& folder,
                                         const recording::ReadProgress& progress) {
  const auto rig = recording::read_rig_json(folder / "rig.json");
  if (!rig) return rig.error();
  const auto bundles = recording::read_rig_bundles(folder, progress);
  if (!bundles) return bundles.error();
  bench::AlignInput input;
  input.name = folder.filename().string();
  input.whole_rig = true;
  std::vector<RigidTransform> world_from_depth;
  for (std::size_t i = 0; i < bundles->size(); ++i) {
    const auto& truth = rig->sensors[i].world_from_depth;
    const auto view = recording::view_of((*bundles)[i]);
    if (!truth || !view) continue;
    input.views.push_back(*view);
    world_from_depth.push_back(*truth);
  }
  for (std::size_t a = 0; a < input.views.size(); ++a) {
    for (std::size_t b = a + 1; b < input.views.size(); ++b) {
      const RigidTransform a_from_b = world_from_depth[a].inverse() * world_from_depth[b];
      const auto check = alignment::check_free_space(
          input.views[a]->surface, input.views[b]->surface, a_from_b, kOverlapPoints);
      input.cases.push_back({a, b, a_from_b, check.min_consistent});
    }
  }
  return input;
}

Result<bench::AlignInput> read_pairs_input(const fs::path& folder,
                                           const recording::ReadProgress& progress) {
  const auto pairs = recording::read_pair_list(folder / kPairList);
  if (!pairs) return pairs.error();
  auto frames = recording::FrameViews::read(folder, *pairs, progress);
  if (!frames) return frames.error();
  bench::AlignInput input;
  input.name = folder.filename().string();
  for (const recording::ListedPair& pair : *pairs) {
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

Status run_fresh(const bench::FreshSuiteOptions& options, bool json) {
  StatusLine line;
  const auto suite =
      bench::run_fresh_suite(options, [&](std::string_view what) { line.show(what); });
  if (!suite) return suite.error();
  json ? bench::print_json(*suite, std::cout) : bench::print_table(*suite, std::cout);
  return {};
}

Result<std::vector<bench::FramesRigRow>> run_frames(const std::vector<std::string>& folders,
                                                    const bench::FramesSuiteOptions& options,
                                                    const bench::BenchProgress& progress) {
  if (folders.empty())
    return Error{ErrorCode::kInvalidArgument, "--suite frames needs --rig with recorded rigs"};
  std::vector<bench::FramesRigRow> rows;
  for (const std::string& folder : folders) {
    const auto rig = read_frames_rig(fs::path(folder).lexically_normal());
    if (!rig) return rig.error();
    rows.push_back(bench::run_frames_suite(*rig, options, progress));
  }
  return rows;
}

/// Prints a suite's rows as a table or as JSON.
template <class Rows>
Status print(const Result<Rows>& rows, bool json) {
  if (!rows) return rows.error();
  json ? bench::print_json(*rows, std::cout) : bench::print_table(*rows, std::cout);
  return {};
}

struct AlignBenchCommand {
  std::vector<std::string> folders;
  std::string suite_name;
  bool json = false;
  int rooms = 16;                   // of the suites corners, join, walker, passers-by, board
  std::vector<std::string> scenes;  // of the suites of fresh rooms and of moved sensors; empty: all
  bench::FreshSuiteOptions suite;
  bench::CornersSuiteOptions corners;
  bench::JoinSuiteOptions join;
  bench::MovedSuiteOptions moved;
  bench::PersonSuiteOptions person;
  bench::BoardSuiteOptions board;
  bench::HarshSuiteOptions harsh;
  std::string harsh_part = "all";
  bench::FramesSuiteOptions frames;
  std::vector<std::string> rigs;  // of the suite of frames
};

Status run(AlignBenchCommand command) {
  command.moved.seed = command.person.seed = command.board.seed = command.corners.seed =
      command.join.seed = command.suite.seed;
  command.board.rooms = command.person.rooms = command.corners.rooms = command.join.rooms =
      command.rooms;
  command.suite.scenes = command.moved.scenes = command.scenes;
  command.harsh.seed = command.suite.seed;
  command.harsh.part = bench::harsh_part_named(command.harsh_part);
  StatusLine line;
  const auto show = [&](std::string_view what) { line.show(what); };
  if (command.suite_name == "corners")
    return print(bench::run_corners_suite(command.corners, show), command.json);
  if (command.suite_name == "harsh")
    return print(bench::run_harsh_suite(command.harsh, show), command.json);
  if (command.suite_name == "frames")
    return print(run_frames(command.rigs, command.frames, show), command.json);
  if (command.suite_name == "join")
    return print(bench::run_join_suite(command.join, show), command.json);
  if (command.suite_name == "moved")
    return print(bench::run_moved_suite(command.moved, show), command.json);
  if (command.suite_name == "board")
    return print(bench::run_board_suite(command.board, show), command.json);
  command.person.unaware = command.suite_name == "passers-by";
  if (command.suite_name == "walker" || command.person.unaware)
    return print(bench::run_person_suite(command.person, show), command.json);
  if (command.suite_name == "fresh") return run_fresh(command.suite, command.json);
  if (!command.folders.empty()) return run_bench(command.folders, command.json);
  return Error{ErrorCode::kInvalidArgument,
               "give recordings with known poses, or --suite fresh, harsh, corners, join, moved, "
               "walker, passers-by or board for simulated rooms, or --suite frames --rig"};
}

void add_harsh_options(CLI::App& command, AlignBenchCommand& values) {
  command
      .add_option("--part", values.harsh_part,
                  "harsh: the kinds on which thresholds are chosen, those from which figures are "
                  "taken, or all")
      ->check(CLI::IsMember({"development", "judged", "all"}))
      ->capture_default_str();
  command.add_option("--kinds", values.harsh.kinds,
                     "harsh: only these rooms, sensors (tof, structured, mixed) or ROOM/SENSORS");
  command.add_option("--rigs-per-kind", values.harsh.rigs, "harsh: number of rigs of each kind")
      ->check(within(1, bench::kHarshRigsPerKind))
      ->capture_default_str();
  command.add_option("--sensors", values.harsh.sensors, "harsh: sensors of a rig")
      ->check(within(2, simulator::kMaxSimulatedSensors))
      ->capture_default_str();
}

void add_frames_options(CLI::App& command, AlignBenchCommand& values) {
  command.add_option("--rig", values.rigs, "frames: folders of recorded rigs");
  command.add_option("--draws", values.frames.draws, "frames: draws from each rig")
      ->check(within(1, 10'000))
      ->capture_default_str();
  command.add_option("--frames", values.frames.frames, "frames: consecutive frames of a draw")
      ->check(within(1, 100))
      ->capture_default_str();
}

}  // namespace

void add_align_bench(CLI::App& bench, Command& chosen) {
  auto values = std::make_shared<AlignBenchCommand>();
  CLI::App* command = bench.add_subcommand(
      "align", "Alignment methods side by side on recordings with known poses");
  command->add_option("recordings", values->folders,
                      "Rigs with poses, or TUM recordings with alignment_pairs.json");
  command
      ->add_option("--suite", values->suite_name,
                   "fresh: simulated rooms of every scene, half of the pairs without overlap; "
                   "corners: errors of four sensors in the corners of a room; join: cost of a "
                   "fifth sensor that joins four; moved: detection of moved sensors among people; "
                   "walker: opposite sensors placed by one walking person; passers-by: by people "
                   "in their usual activities; board: by a printed board; harsh: uncalibrated "
                   "sensors in difficult rooms, kind by kind; frames: draws of consecutive frames "
                   "of recorded rigs")
      ->check(CLI::IsMember({"fresh", "corners", "join", "moved", "walker", "passers-by", "board",
                             "harsh", "frames"}));
  add_harsh_options(*command, *values);
  add_frames_options(*command, *values);
  command->add_option("--pairs", values->suite.pairs, "Number of pairs in the suite")
      ->check(within(1, 100'000))
      ->capture_default_str();
  command
      ->add_option("--seed", values->suite.seed,
                   "Seed of the suite's first room; other seeds give other rooms")
      ->check(seed_number())
      ->capture_default_str();
  command
      ->add_option("--minutes", values->moved.minutes,
                   "moved: minutes of observation in each scene")
      ->check(within(0.1, 1000.0))
      ->capture_default_str();
  command->add_option("--scene", values->scenes, "fresh, moved: only these scenes");
  command
      ->add_option("--rooms", values->rooms,
                   "corners, join, walker, passers-by, board: number of rooms")
      ->check(within(1, 10'000))
      ->capture_default_str();
  command->add_flag("--json", values->json, "Print JSON");
  command->footer(
      "Example:\n  roomcast bench align recordings/lab recordings/kitchen --json\n"
      "  roomcast bench align --suite fresh --pairs 200 --seed 5000\n"
      "  roomcast bench align --suite harsh --part judged --kinds structured\n"
      "  roomcast bench align --suite frames --rig recordings/lab recordings/kitchen");
  command->callback(
      [values, &chosen] { chosen = [values] { return finish("bench align", run(*values)); }; });
}

}  // namespace roomcast::cli
