// SPDX-License-Identifier: Apache-2.0
// roomcast study: checks the plan of a study with people, exports its sessions and compares its
// conditions, says how to film what a participant saw, erases participants.
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/print.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/io/new_folder.h"
#include "roomcast/recording/recorder/unix_clock.h"
#include "roomcast/recording/room/room_recording.h"
#include "roomcast/study/comparison_pictures.h"
#include "roomcast/study/counterbalance.h"
#include "roomcast/study/plan.h"
#include "roomcast/study/session_path.h"
#include "roomcast/study/study_export.h"
#include "roomcast/study/study_folder.h"
#include "roomcast/study/study_report.h"

namespace roomcast::cli {
namespace {

struct StudyOptions {
  std::filesystem::path plan, folder, out, recording;
  std::string participant;
  bool json = false;
};

nlohmann::json faults_json(const study::ReadPlan& read) {
  nlohmann::json faults = nlohmann::json::array();
  for (const auto& [line, sentence] : read.faults)
    faults.push_back({{"line", line}, {"sentence", sentence}});
  return faults;
}

double condition_minutes(const study::StudyPlan& plan) {
  double seconds = 0;
  for (const auto& condition : plan.conditions) seconds += condition.seconds;
  return seconds / 60;
}

std::string order_text(const study::StudyPlan& plan, std::size_t participant) {
  std::string text;
  for (const std::size_t condition :
       study::order_for(participant, plan.conditions.size(), plan.order, plan.name))
    text += (text.empty() ? "" : ", ") + plan.conditions[condition].name;
  return text;
}

void print_plan(const study::StudyPlan& plan) {
  std::size_t items = 0;
  for (const auto& questions : plan.questionnaires) items += questions.items.size();
  print_out("{}: {} conditions, {:.1f} minutes in all; {} questionnaires with {} items\n",
            plan.name, plan.conditions.size(), condition_minutes(plan), plan.questionnaires.size(),
            items);
  constexpr std::size_t kShown = 12;
  const std::size_t square = study::participants_per_square(plan.conditions.size(), plan.order);
  const std::size_t shown = plan.order == study::ConditionOrder::kFixed
                                ? 1
                                : std::min(std::max(square, std::size_t{4}), kShown);
  for (std::size_t i = 0; i < shown; ++i) print_out("P{:03}: {}\n", i + 1, order_text(plan, i));
  if (square > 1)
    print_out("the orders repeat after {} participants: invite a multiple of that\n", square);
}

Outcome check_plan_file(const StudyOptions& options) {
  std::vector<std::uint8_t> bytes;
  if (auto status = io::read_file(options.plan, study::kMaxPlanBytes, bytes); !status)
    return status.error();
  const study::ReadPlan read =
      study::read_plan({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (options.json) {
    nlohmann::json json = {{"plan", options.plan.string()}, {"faults", faults_json(read)}};
    if (read.faults.empty()) json["study"] = study::to_json(read.plan);
    print_out("{}\n", json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    for (const auto& [line, sentence] : read.faults) {
      if (line > 0)
        print_err("{}, line {}: {}\n", options.plan.string(), line, one_line(sentence));
      else
        print_err("{}: {}\n", options.plan.string(), one_line(sentence));
    }
    if (read.faults.empty()) print_plan(read.plan);
  }
  if (read.faults.empty()) {
    const auto pictures = study::ComparisonPictures::find(read.plan, options.plan.parent_path());
    return {pictures ? Status() : Status(pictures.error()), options.json};
  }
  const std::size_t count = read.faults.size();
  return {Error{ErrorCode::kMalformed,
                fmt::format("this plan has {} mistake{}", count, count == 1 ? "" : "s")},
          options.json};
}

Outcome export_study(const StudyOptions& options) {
  const auto folder = study::StudyFolder::open(options.folder);
  if (!folder) return folder.error();
  const auto done = study::export_csv(*folder, options.out);
  if (!done) return done.error();
  if (options.json) {
    print_out("{}\n", nlohmann::json{{"study", folder->study()},
                                     {"out", options.out.string()},
                                     {"participants", done->participants},
                                     {"rows", done->rows}}
                          .dump(1));
    return Status();
  }
  for (const auto& [file, rows] : done->rows)
    print_out("{}: {} rows\n", (options.out / file).string(), rows);
  return Status();
}

Outcome report_study(const StudyOptions& options) {
  const auto folder = study::StudyFolder::open(options.folder);
  if (!folder) return folder.error();
  const auto summary = study::summarise(*folder);
  if (!summary) return summary.error();
  if (summary->measures.empty() && summary->comparisons.empty())
    return Error{ErrorCode::kNotFound, "nobody has gone through a condition of this study yet"};
  if (auto status = study::write_report(*summary, options.out); !status) return status.error();
  if (options.json) {
    nlohmann::json measures = nlohmann::json::array();
    for (const auto& measure : summary->measures)
      measures.push_back({{"name", measure.name}, {"values", measure.values}});
    nlohmann::json comparisons = nlohmann::json::array();
    for (const auto& [name, answers, correct, low, high] : summary->comparisons)
      comparisons.push_back({{"name", name},
                             {"answers", answers},
                             {"correct", correct},
                             {"low_share", low},
                             {"high_share", high}});
    print_out("{}\n", nlohmann::json{{"study", summary->study},
                                     {"comparisons", std::move(comparisons)},
                                     {"out", options.out.string()},
                                     {"participants", summary->participants},
                                     {"measures", std::move(measures)}}
                          .dump(1));
    return Status();
  }
  print_out("{}: {} participants, {} measures\n", (options.out / "report.html").string(),
            summary->participants, summary->measures.size());
  return Status();
}

/// One word for a shell, whatever is in it.
std::string shell_word(const std::string& text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// The command that films a condition.
std::string film_command(const StudyOptions& options, const study::SeenCondition& seen) {
  const std::string base = (options.out / seen.name).string();
  return fmt::format(
      "roomcast export {} --format video --out {} --path {} --from {:.3f} --to {:.3f}{}",
      shell_word(options.recording.string()), shell_word(base), shell_word(base + ".json"),
      seen.from_s, seen.to_s, seen.mode.empty() ? "" : " --mode " + seen.mode);
}

Outcome replay_session(const StudyOptions& options) {
  const auto folder = study::StudyFolder::open(options.folder);
  if (!folder) return folder.error();
  const auto recording = recording::RoomRecording::open(options.recording);
  if (!recording) return recording.error();
  const auto seen = study::seen_conditions(*folder, options.participant, recording->start(),
                                           recording->end() - recording->start());
  if (!seen) return seen.error();
  if (auto status = io::make_folder(options.out); !status) return status.error();
  nlohmann::json conditions = nlohmann::json::array();
  for (const auto& condition : *seen) {
    const auto file = options.out / (condition.name + ".json");
    if (auto status = io::write_file(file, study::path_json(condition.keys)); !status)
      return status.error();
    if (!options.json) print_out("{}\n", film_command(options, condition));
    conditions.push_back({{"condition", condition.name},
                          {"path", file.string()},
                          {"from_s", condition.from_s},
                          {"to_s", condition.to_s},
                          {"command", film_command(options, condition)}});
  }
  if (options.json)
    print_out("{}\n", nlohmann::json{{"participant", options.participant},
                                     {"conditions", std::move(conditions)}}
                          .dump(1));
  return Status();
}

Outcome erase_participant(const StudyOptions& options) {
  auto folder = study::StudyFolder::open(options.folder);
  if (!folder) return folder.error();
  if (auto status = folder->erase(options.participant, recording::UnixClock().now()); !status)
    return status.error();
  print_out("{} is erased from {}; erase it from exported files and backups, too\n",
            options.participant, options.folder.string());
  return Status();
}

}  // namespace

void add_study_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<StudyOptions>();
  CLI::App* command = app.add_subcommand(
      "study",
      "Studies with people: check a plan, export and compare sessions, erase a participant");
  command->require_subcommand(1);

  CLI::App* example = command->add_subcommand("example", "Print a plan to begin with");
  example->footer("Example:\n  roomcast study example > plan.toml");
  example->callback([&chosen] {
    chosen = [] {
      print_out("{}", study::example_plan());
      return finish("study", Outcome(Status()));
    };
  });

  CLI::App* check = command->add_subcommand("check", "Say what a plan does, or all its mistakes");
  check->add_option("plan", options->plan, "PLAN.toml")->required();
  check->add_flag("--json", options->json, "Print JSON");
  check->footer("Example:\n  roomcast study check plan.toml");
  check->callback([options, &chosen] {
    chosen = [options] { return finish("study", check_plan_file(*options)); };
  });

  CLI::App* to_csv = command->add_subcommand("export", "Write all sessions as CSV files");
  to_csv->add_option("folder", options->folder, "Folder of the study")->required();
  to_csv->add_option("--csv", options->out, "New folder to write to")->required();
  to_csv->add_flag("--json", options->json, "Print JSON");
  to_csv->footer(
      "data_dictionary.csv says what every column means.\n"
      "Example:\n  roomcast study export study-delay --csv delay-csv");
  to_csv->callback([options, &chosen] {
    chosen = [options] { return finish("study", export_study(*options)); };
  });

  CLI::App* report = command->add_subcommand(
      "report", "Compare the conditions: figures, and their means with intervals");
  report->add_option("folder", options->folder, "Folder of the study")->required();
  report->add_option("--out", options->out, "New folder to write to")->required();
  report->add_flag("--json", options->json, "Print JSON, with the value of each participant");
  report->footer(
      "report.html has all figures; each is also a file of its own, NAME.svg.\n"
      "Example:\n  roomcast study report study-delay --out delay-report");
  report->callback([options, &chosen] {
    chosen = [options] { return finish("study", report_study(*options)); };
  });

  CLI::App* replay = command->add_subcommand(
      "replay", "Say how to film a recording as a participant saw the room");
  replay->add_option("folder", options->folder, "Folder of the study")->required();
  replay->add_option("participant", options->participant, "Its number, as P007")->required();
  replay->add_option("--recording", options->recording, "FILE.mcap of the room, of that time")
      ->required();
  replay->add_option("--out", options->out, "Folder for the ways of the head")->required();
  replay->add_flag("--json", options->json, "Print JSON");
  replay->footer(
      "It prints a command for each condition.\n"
      "Example:\n  roomcast study replay study-delay P007 --recording lab.mcap --out seen | sh");
  replay->callback([options, &chosen] {
    chosen = [options] { return finish("study", replay_session(*options)); };
  });

  CLI::App* erase = command->add_subcommand("erase", "Erase all of a participant, for good");
  erase->add_option("folder", options->folder, "Folder of the study")->required();
  erase->add_option("participant", options->participant, "Its number, as P007")->required();
  erase->footer("Example:\n  roomcast study erase study-delay P007");
  erase->callback([options, &chosen] {
    chosen = [options] { return finish("study", erase_participant(*options)); };
  });

  command->footer(
      "Run a study with: roomcast hub --study plan.toml; participants open its address with "
      "?study=1.\n"
      "Examples:\n"
      "  roomcast study example > plan.toml\n"
      "  roomcast study check plan.toml\n"
      "  roomcast study export ~/.local/state/roomcast/study-delay --csv delay-csv\n"
      "  roomcast study report ~/.local/state/roomcast/study-delay --out delay-report\n"
      "  roomcast study erase ~/.local/state/roomcast/study-delay P007");
}

}  // namespace roomcast::cli
