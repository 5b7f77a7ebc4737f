// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "roomcast/io/file_bytes.h"
#include "roomcast/study/plan.h"
#include "roomcast/study/toml_reader.h"

namespace roomcast::study {
namespace {

constexpr double kLongestCondition_s = 4 * 3600;
constexpr double kMaxLatency_ms = 10'000;
constexpr double kMaxFps = 240;
constexpr int kMaxPoints = 101;
constexpr std::size_t kMaxParticipants = 10'000;

/// Reads a plan and collects what is wrong.
class PlanReader : private TomlReader {
 public:
  ReadPlan read(std::string_view text);

 private:
  void read_study(const toml::table& table);
  void read_condition(const toml::table& table);
  void read_questionnaire(const toml::table& table);
  void read_when(const toml::node& node, Questionnaire& into);
  void read_item(const toml::table& table, Questionnaire& into);
  void read_comparison(const toml::table& table);
  void check_item(const toml::table& table, const QuestionItem& item);
  void check_whole(const toml::table& root);

  ReadPlan result_;
  std::set<std::string> condition_names_, questionnaire_names_;
};

ReadPlan PlanReader::read(std::string_view text) {
  const toml::parse_result parsed = toml::parse(text);
  if (!parsed) {
    const toml::parse_error& error = parsed.error();
    fault(error.source().begin.line, "this is not TOML: " + std::string(error.description()));
    result_.faults = take_faults();
    return std::move(result_);
  }
  const toml::table& root = parsed.table();
  const auto study = [this](const toml::node& node) {
    if (const auto* table = node.as_table()) return read_study(*table);
    fault(line_of(node), "write [study] on a line of its own, and its settings below");
  };
  read_table(root, "a plan",
             {{"study", study},
              {"condition",
               [this](const toml::node& node) {
                 each_table(node, "condition", kMaxConditions,
                            [this](const toml::table& one) { read_condition(one); });
               }},
              {"comparison",
               [this](const toml::node& node) {
                 each_table(node, "comparison", kMaxComparisons,
                            [this](const toml::table& one) { read_comparison(one); });
               }},
              {"questionnaire", [this](const toml::node& node) {
                 each_table(node, "questionnaire", kMaxQuestionnaires,
                            [this](const toml::table& one) { read_questionnaire(one); });
               }}});
  check_whole(root);
  result_.faults = take_faults();
  return std::move(result_);
}

void PlanReader::read_study(const toml::table& table) {
  StudyPlan& plan = result_.plan;
  const auto into = [this](std::string& field) {
    return [this, &field](const toml::node& node) { text(node, field); };
  };
  read_table(table, "[study]",
             {{"name", [&](const toml::node& node) { plain_name(node, plan.name); }},
              {"title", into(plan.title)},
              {"room", into(plan.room)},
              {"consent", into(plan.consent)},
              {"thanks", into(plan.thanks)},
              {"order",
               [&](const toml::node& node) {
                 one_of<ConditionOrder>(node,
                                        {{"balanced", ConditionOrder::kBalanced},
                                         {"fixed", ConditionOrder::kFixed},
                                         {"random", ConditionOrder::kRandom}},
                                        plan.order);
               }},
              {"participants", [&](const toml::node& node) {
                 double most = static_cast<double>(plan.participants);
                 number(node, 1, kMaxParticipants, most);
                 plan.participants = static_cast<std::size_t>(most);
               }}});
  need(table, "[study]", "name");
  need(table, "[study]", "consent");
  if (table.contains("consent") && plan.consent.empty())
    fault(line_of(*table.get("consent")),
          "without a text that people agree to nobody can take part");
}

void PlanReader::read_condition(const toml::table& table) {
  Condition& condition = result_.plan.conditions.emplace_back();
  read_table(
      table, "a condition",
      {{"name", [&](const toml::node& node) { plain_name(node, condition.name); }},
       {"seconds",
        [&](const toml::node& node) { number(node, 1, kLongestCondition_s, condition.seconds); }},
       {"instruction", [&](const toml::node& node) { text(node, condition.instruction); }},
       {"room", [&](const toml::node& node) { text(node, condition.room); }},
       {"mode",
        [&](const toml::node& node) {
          one_of<std::string>(node, {{"blend", "blend"}, {"mesh", "mesh"}, {"points", "points"}},
                              condition.mode);
        }},
       {"latency_ms",
        [&](const toml::node& node) { number(node, 0, kMaxLatency_ms, condition.latency_ms); }},
       {"fps", [&](const toml::node& node) { number(node, 0.1, kMaxFps, condition.fps); }},
       {"sensors_off", [&](const toml::node& node) { texts(node, condition.sensors_off); }},
       {"voice", [&](const toml::node& node) { flag(node, condition.voice); }}});
  need(table, "a condition", "name");
  if (!condition.name.empty() && !condition_names_.insert(condition.name).second)
    fault(line_of(table), fmt::format("there are two conditions named \"{}\"", condition.name));
}

void PlanReader::read_when(const toml::node& node, Questionnaire& into) {
  std::vector<std::string> times;
  texts(node, times);
  for (const std::string& time : times) {
    if (time == "before") {
      into.before = true;
    } else if (time == "after-condition") {
      into.after_condition = true;
    } else if (time == "after") {
      into.after = true;
    } else {
      fault(line_of(node), fmt::format("\"{}\" is no time for a questionnaire: there are "
                                       "\"before\", \"after-condition\" and \"after\"",
                                       time));
    }
  }
}

void PlanReader::read_questionnaire(const toml::table& table) {
  Questionnaire& questions = result_.plan.questionnaires.emplace_back();
  const auto read_times = [&](const toml::node& node) {
    const toml::array* list = node.as_array();
    if (list == nullptr) return fault(line_of(node), "this must be a list of seconds: [60, 120]");
    for (const toml::node& one : *list)
      number(one, 1, kLongestCondition_s, questions.at_s.emplace_back());
    std::ranges::sort(questions.at_s);
  };
  read_table(table, "a questionnaire",
             {{"name", [&](const toml::node& node) { plain_name(node, questions.name); }},
              {"title", [&](const toml::node& node) { text(node, questions.title); }},
              {"intro", [&](const toml::node& node) { text(node, questions.intro); }},
              {"when", [&](const toml::node& node) { read_when(node, questions); }},
              {"at_s", read_times},
              {"item", [&](const toml::node& node) {
                 each_table(node, "questionnaire.item", kMaxItems,
                            [&](const toml::table& one) { read_item(one, questions); });
               }}});
  need(table, "a questionnaire", "name");
  need(table, "a questionnaire", "item");
  if (!table.contains("when") && !table.contains("at_s"))
    fault(line_of(table), "a questionnaire needs \"when\" or \"at_s\", else it is never shown");
  if (!questions.name.empty() && !questionnaire_names_.insert(questions.name).second)
    fault(line_of(table), fmt::format("there are two questionnaires named \"{}\"", questions.name));
}

void PlanReader::read_comparison(const toml::table& table) {
  Comparison& comparison = result_.plan.comparisons.emplace_back();
  const auto into = [this](std::string& field) {
    return [this, &field](const toml::node& node) { text(node, field); };
  };
  read_table(table, "a comparison",
             {{"name", [&](const toml::node& node) { plain_name(node, comparison.name); }},
              {"title", into(comparison.title)},
              {"intro", into(comparison.intro)},
              {"question", into(comparison.question)},
              {"real", into(comparison.real)},
              {"drawn", into(comparison.drawn)},
              {"seconds", [&](const toml::node& node) { number(node, 0, 60, comparison.seconds); }},
              {"when", [&](const toml::node& node) {
                 one_of<bool>(node, {{"before", true}, {"after", false}}, comparison.before);
               }}});
  for (const char* key : {"name", "real", "drawn"}) need(table, "a comparison", key);
  const auto same =
      std::ranges::count(result_.plan.comparisons, comparison.name, &Comparison::name);
  if (!comparison.name.empty() && same > 1)
    fault(line_of(table), fmt::format("there are two comparisons named \"{}\"", comparison.name));
}

void PlanReader::read_item(const toml::table& table, Questionnaire& into) {
  QuestionItem item;
  using Kind = QuestionItem::Kind;
  if (table.contains("choices")) item.kind = Kind::kChoice;
  read_table(table, "an item",
             {{"name", [&](const toml::node& node) { plain_name(node, item.name); }},
              {"text", [&](const toml::node& node) { text(node, item.text); }},
              {"kind",
               [&](const toml::node& node) {
                 one_of<Kind>(node,
                              {{"scale", Kind::kScale},
                               {"choice", Kind::kChoice},
                               {"number", Kind::kNumber},
                               {"text", Kind::kText}},
                              item.kind);
               }},
              {"points",
               [&](const toml::node& node) {
                 double points = item.points;
                 number(node, 2, kMaxPoints, points);
                 item.points = static_cast<int>(points);
               }},
              {"labels", [&](const toml::node& node) { texts(node, item.labels); }},
              {"choices", [&](const toml::node& node) { texts(node, item.choices); }},
              {"required", [&](const toml::node& node) { flag(node, item.required); }}});
  need(table, "an item", "name");
  need(table, "an item", "text");
  check_item(table, item);
  if (std::ranges::count(into.items, item.name, &QuestionItem::name) > 0)
    fault(line_of(table), fmt::format("there are two items named \"{}\"", item.name));
  into.items.push_back(std::move(item));
}

void PlanReader::check_item(const toml::table& table, const QuestionItem& item) {
  using Kind = QuestionItem::Kind;
  const auto labels = static_cast<int>(item.labels.size());
  if (item.kind == Kind::kScale && labels != 0 && labels != 2 && labels != item.points) {
    fault(line_of(table), fmt::format("a scale of {} points has 2 labels, for its ends, or {}; "
                                      "these are {}",
                                      item.points, item.points, labels));
  }
  if (item.kind == Kind::kChoice && item.choices.size() < 2)
    fault(line_of(table), "a choice needs at least two \"choices\"");
  if (item.kind != Kind::kChoice && !item.choices.empty())
    fault(line_of(table), "only items of the kind \"choice\" have \"choices\"");
}

void PlanReader::check_whole(const toml::table& root) {
  if (!root.contains("study")) fault(0, "the plan has no [study]");
  if (!root.contains("condition")) fault(0, "the plan has no [[condition]]");
  for (const Questionnaire& questions : result_.plan.questionnaires) {
    for (const double at_s : questions.at_s) {
      const auto is_longer = [at_s](const Condition& c) { return c.seconds > at_s; };
      if (std::ranges::none_of(result_.plan.conditions, is_longer))
        fault(0, fmt::format("\"{}\" is to be shown after {:g} s, but no condition is that long",
                             questions.name, at_s));
    }
  }
}

}  // namespace

ReadPlan read_plan(std::string_view toml) {
  return PlanReader().read(toml);
}

Result<StudyPlan> load_plan(const std::filesystem::path& file) {
  std::vector<std::uint8_t> bytes;
  if (auto status = io::read_file(file, kMaxPlanBytes, bytes); !status) return status.error();
  return plan_of({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file);
}

Result<StudyPlan> plan_of(std::string_view toml, const std::filesystem::path& file) {
  ReadPlan read = read_plan(toml);
  if (read.faults.empty()) return std::move(read.plan);
  const auto& [line, sentence] = read.faults.front();
  return Error{ErrorCode::kMalformed,
               line > 0 ? fmt::format("{}, line {}: {}", file.string(), line, sentence)
                        : fmt::format("{}: {}", file.string(), sentence)};
}

}  // namespace roomcast::study
