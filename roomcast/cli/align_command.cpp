// SPDX-License-Identifier: Apache-2.0
// roomcast align: estimates the poses of a recording's sensors and reports their expected errors.
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "roomcast/alignment/alignment_options.h"
#include "roomcast/cli/alignment_text.h"
#include "roomcast/cli/command.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/rig_poses.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/recording/align/pair_list.h"
#include "roomcast/recording/align/recorded_alignment.h"
#include "roomcast/recording/align/recorded_views.h"

namespace roomcast::cli {
namespace {

struct AlignOptions {
  std::string recording;
  std::string method = "auto";
  std::string pairs;
  bool json = false, verbose = false, write = false;
  alignment::AlignmentOptions stages;
};

alignment::PairReport align_pair(const recording::ListedPair& pair, const AlignOptions& options,
                                 recording::FrameViews& frames) {
  alignment::PairReport refused;
  refused.a = pair.a;
  refused.b = pair.b;
  refused.reason = pair.a + " is listed as a pair with itself; name two frames";
  if (pair.a == pair.b) return refused;
  std::vector<recording::SharedView> views;
  for (const std::string& name : {pair.a, pair.b}) {
    const auto& view = frames.at(name);
    if (!view) {
      refused.reason = view.error().message;
      return refused;
    }
    views.push_back(*view);
  }
  return recording::align_views(views, options.method, options.stages, {}).pairs.at(0);
}

Result<alignment::AlignmentReport> align_pairs(const AlignOptions& options, StatusLine& line) {
  const auto pairs = recording::read_pair_list(options.pairs);
  if (!pairs) return pairs.error();
  auto frames = recording::FrameViews::read(
      options.recording, *pairs, [&](const std::string& what) { line.show(what); }, options.stages);
  if (!frames) return frames.error();
  alignment::AlignmentReport report;
  for (const recording::ListedPair& pair : *pairs) {
    line.show(fmt::format("pair {} of {}: {} and {}", report.pairs.size() + 1, pairs->size(),
                          pair.a, pair.b));
    report.pairs.push_back(align_pair(pair, options, *frames));
  }
  return report;
}

Status check_recording(const AlignOptions& options) {
  std::error_code ignored;
  const std::filesystem::path folder(options.recording);
  if (!std::filesystem::is_directory(folder, ignored)) {
    return Error{ErrorCode::kNotFound, "there is no folder " + options.recording};
  }
  if (options.pairs.empty() && !std::filesystem::exists(folder / "rig.json", ignored)) {
    return Error{
        ErrorCode::kInvalidArgument,
        options.recording +
            " has no rig.json, so it holds one sensor at most; give --pairs to align frames "
            "of it with each other"};
  }
  return {};
}

std::string text_of(const alignment::AlignmentReport& report, const AlignOptions& options) {
  if (!options.json) return alignment_table(report);
  return options.verbose ? alignment_json(report, options.stages) : alignment_json(report);
}

Status run_align(const AlignOptions& options) {
  if (Status status = check_recording(options); !status) return status;
  StatusLine line;
  const auto show = [&line](const std::string& what) { line.show(what); };
  const auto report = options.pairs.empty() ? recording::align_recording(
                                                  options.recording, options.method, options.stages,
                                                  show, alignment::DepthScaling::kEstimated)
                                            : align_pairs(options, line);
  if (!report) return report.error();
  if (options.write) {
    if (Status written = write_rig_poses(options.recording, *report); !written) return written;
  }
  print_out("{}", text_of(*report, options));
  return {};
}

}  // namespace

void add_align_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<AlignOptions>();
  CLI::App* command = app.add_subcommand(
      "align", "Align the sensors of a recording and report their expected errors");
  command->add_option("recording", options->recording, "Folder of a rig or of a TUM recording")
      ->required();
  command->add_option("--method", options->method, "auto, or homography (the baseline)")
      ->check(CLI::IsMember({"auto", "homography"}))
      ->capture_default_str();
  command->add_option(
      "--pairs", options->pairs,
      "Align these pairs of frames of a TUM recording instead (alignment_pairs.json)");
  command
      ->add_flag("--write", options->write,
                 "Write the poses and depth scales into the rig's rig.json; a refused sensor gets "
                 "no pose and keeps its depth scale")
      ->excludes("--pairs");
  CLI::Option* json = command->add_flag("--json", options->json, "Print JSON");
  command
      ->add_flag("--verbose", options->verbose,
                 "With --json: add the numbers of every stage, as options")
      ->needs(json);
  command->footer("Example:\n  roomcast align recordings/lab --json");
  command->callback(
      [options, &chosen] { chosen = [options] { return finish("align", run_align(*options)); }; });
}

}  // namespace roomcast::cli
