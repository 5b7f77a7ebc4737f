// SPDX-License-Identifier: Apache-2.0
// roomcast align: places the sensors of a recording, and says how sure it is.
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "roomcast/align/rig/rig_aligner.h"
#include "roomcast/cli/alignment_text.h"
#include "roomcast/cli/command.h"
#include "roomcast/cli/pair_list.h"
#include "roomcast/cli/recorded_bundles.h"
#include "roomcast/cli/status_line.h"

namespace roomcast::cli {
namespace {

struct AlignOptions {
  std::string recording;
  std::string method = "auto";
  std::string pairs;
  bool json = false;
};

using SharedView = std::shared_ptr<const align::SensorView>;

Result<SharedView> view_of(const RecordedBundle& recorded) {
  if (!recorded.bundle) return recorded.bundle.error();
  auto view = align::make_sensor_view(*recorded.bundle);
  if (!view) return view.error();
  return SharedView(std::make_shared<const align::SensorView>(std::move(*view)));
}

align::SensorReport unusable_sensor(const std::string& name, const Error& error) {
  align::SensorReport report;
  report.id = name;
  report.reason = error.message;
  return report;
}

Result<align::AlignmentReport> align_rig(const std::filesystem::path& directory, StatusLine& line) {
  const auto bundles =
      read_rig_bundles(directory, [&](const std::string& what) { line.show(what); });
  if (!bundles) return bundles.error();
  align::RigAligner aligner;
  std::vector<align::SensorReport> unusable;
  for (const RecordedBundle& recorded : *bundles) {
    line.show("looking at " + recorded.name);
    const auto view = view_of(recorded);
    view ? aligner.add(*view) : unusable.push_back(unusable_sensor(recorded.name, view.error()));
  }
  align::AlignmentReport report = aligner.solve([&](std::string_view step, double done) {
    line.show(fmt::format("{:3.0f} %  {}", 100 * done, step));
  });
  report.sensors.insert(report.sensors.end(), unusable.begin(), unusable.end());
  return report;
}

/// The views of all frames that any pair names, each made once.
class FrameViews {
 public:
  static Result<FrameViews> read(const std::filesystem::path& directory,
                                 const std::vector<ListedPair>& pairs, StatusLine& line) {
    std::set<std::uint64_t> frames;
    for (const ListedPair& pair : pairs) {
      for (const std::string& name : {pair.a, pair.b}) {
        const auto number = frame_number(name);
        if (!number) return number.error();
        frames.insert(*number);
      }
    }
    auto bundles =
        read_frame_bundles(directory, frames, [&](const std::string& what) { line.show(what); });
    if (!bundles) return bundles.error();
    return FrameViews(std::move(*bundles));
  }

  const Result<SharedView>& at(const std::string& name) {
    const std::uint64_t frame = *frame_number(name);
    auto found = views_.find(frame);
    if (found == views_.end()) {
      found = views_.emplace(frame, view_of(bundles_.at(frame))).first;
    }
    return found->second;
  }

 private:
  explicit FrameViews(std::map<std::uint64_t, RecordedBundle> bundles)
      : bundles_(std::move(bundles)) {}

  static Result<std::uint64_t> frame_number(const std::string& name) {
    if (!name.empty() && name.size() < 19 &&
        name.find_first_not_of("0123456789") == std::string::npos) {
      return std::stoull(name);
    }
    return Error{ErrorCode::kInvalidArgument, name + " is no frame number of a TUM recording"};
  }

  std::map<std::uint64_t, RecordedBundle> bundles_;
  std::map<std::uint64_t, Result<SharedView>> views_;
};

align::PairReport align_pair(const ListedPair& pair, FrameViews& views) {
  align::PairReport refused;
  refused.a = pair.a;
  refused.b = pair.b;
  align::RigAligner aligner;
  for (const std::string& name : {pair.a, pair.b}) {
    const auto& view = views.at(name);
    if (!view) {
      refused.reason = view.error().message;
      return refused;
    }
    aligner.add(*view);
  }
  return aligner.solve().pairs.at(0);
}

Result<align::AlignmentReport> align_pairs(const AlignOptions& options, StatusLine& line) {
  const auto pairs = read_pair_list(options.pairs);
  if (!pairs) return pairs.error();
  auto views = FrameViews::read(options.recording, *pairs, line);
  if (!views) return views.error();
  align::AlignmentReport report;
  for (const ListedPair& pair : *pairs) {
    line.show(fmt::format("pair {} of {}: {} and {}", report.pairs.size() + 1, pairs->size(),
                          pair.a, pair.b));
    report.pairs.push_back(align_pair(pair, *views));
  }
  return report;
}

Status run_align(const AlignOptions& options) {
  StatusLine line;
  const auto report =
      options.pairs.empty() ? align_rig(options.recording, line) : align_pairs(options, line);
  if (!report) return report.error();
  fmt::print("{}", options.json ? alignment_json(*report) : alignment_table(*report));
  return {};
}

}  // namespace

void add_align_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<AlignOptions>();
  CLI::App* command = app.add_subcommand(
      "align", "Place the sensors of a recording in one world, and say how sure that is");
  command->add_option("recording", options->recording, "Folder of a rig or of a TUM recording")
      ->required();
  command->add_option(
      "--pairs", options->pairs,
      "Align these pairs of frames of a TUM recording instead (alignment_pairs.json)");
  command->add_flag("--json", options->json, "For scripts");
  command->footer("Example:\n  roomcast align recordings/lab --json");
  command->callback(
      [options, &chosen] { chosen = [options] { return finish("align", run_align(*options)); }; });
}

}  // namespace roomcast::cli
