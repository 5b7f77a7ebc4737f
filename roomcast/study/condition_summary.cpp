// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/condition_summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "roomcast/study/log_records.h"
#include "roomcast/study/plan.h"

namespace roomcast::study {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// Student's t at 97.5 % for 1 to 30 degrees of freedom: any table of it.
constexpr std::array kStudentT = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306,
                                  2.262,  2.228, 2.201, 2.179, 2.160, 2.145, 2.131, 2.120,
                                  2.110,  2.101, 2.093, 2.086, 2.080, 2.074, 2.069, 2.064,
                                  2.060,  2.056, 2.052, 2.048, 2.045, 2.042};
constexpr double kNormal = 1.960;

double student_t(std::size_t freedom) {
  if (freedom <= kStudentT.size()) return kStudentT[freedom - 1];
  return kNormal + 2.5 / static_cast<double>(freedom);  // within 0.005
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// All values of one participant in one condition, by measure.
struct Gathered {
  std::map<std::string, std::vector<double>> values;
  double began_s = 0, seconds = 0, spoken_s = 0, walked_m = 0;
  std::optional<double> speaks_since_s;
  std::optional<std::array<double, 3>> head_m;
};

struct Known {
  std::string name, title, unit;
  bool is_median = false;
};

constexpr const char *kWalked = "walked_m_min", *kSpoken = "spoken_share";

std::vector<Known> measures_of(const StudyPlan& plan) {
  std::vector<Known> known;
  for (const Questionnaire& questions : plan.questionnaires) {
    for (const QuestionItem& item : questions.items) {
      if (item.kind == QuestionItem::Kind::kScale || item.kind == QuestionItem::Kind::kNumber)
        known.push_back({questions.name + "." + item.name, item.text, "", false});
    }
  }
  known.push_back({"latency_ms", "Latency, capture to drawing", "ms", true});
  known.push_back({"fps", "Pictures a second", "1/s", true});
  known.push_back({"mbit", "Data received", "Mbit/s", true});
  known.push_back({kWalked, "Way of the head", "m/min", false});
  known.push_back({kSpoken, "Share of the time in which the participant spoke", "", false});
  return known;
}

/// Goes through the records of a participant.
class SessionReader {
 public:
  explicit SessionReader(const StudyPlan& plan) {
    for (const Questionnaire& questions : plan.questionnaires)
      if (questions.after_condition) after_condition_.insert(questions.name);
  }

  void take(const Json& record) {
    const std::string& kind = record.at("kind").get_ref<const std::string&>();
    const double t = record.at("t").get<double>();
    if (const auto condition = condition_after(record)) return enter(*condition, t);
    if (kind == "answers") return answer(record);
    if (kind == "comparisons") return compared(record);
    if (now_.empty()) return;
    Gathered& here = by_condition[now_];
    if (kind == "figures") {
      for (const char* name : {"latency_ms", "fps", "mbit"}) {
        const double value = record.at(name).get<double>();
        if (value > 0 || std::string_view(name) != "latency_ms") here.values[name].push_back(value);
      }
    } else if (kind == "poses") {
      const std::array<double, 3> head = {record.at("x"), record.at("y"), record.at("z")};
      if (const auto& before = here.head_m)
        here.walked_m +=
            std::hypot(head[0] - (*before)[0], head[1] - (*before)[1], head[2] - (*before)[2]);
      here.head_m = head;
    } else if (kind == "speech") {
      speech(record.at("on").get<bool>(), t, here);
    }
  }

  std::map<std::string, Gathered> by_condition;
  std::map<std::string, std::pair<std::size_t, std::size_t>> comparisons;  // answers, correct ones

 private:
  void compared(const Json& record) {
    auto& [answers, correct] = comparisons[record.at("comparison").get<std::string>()];
    ++answers;
    correct += record.at("correct") == true;
  }

  /// An empty name ends the condition.
  void enter(const std::string& condition, double t) {
    if (!condition.empty()) {
      last_ = now_ = condition;
      by_condition[now_].began_s = t;
      by_condition[now_].head_m.reset();
      return;
    }
    if (now_.empty()) return;
    Gathered& ended = by_condition[now_];
    speech(false, t, ended);
    ended.seconds += t - ended.began_s;
    now_.clear();
  }

  static void speech(bool on, double t, Gathered& here) {
    if (!on && here.speaks_since_s) here.spoken_s += t - *here.speaks_since_s;
    here.speaks_since_s = on ? std::optional(t) : std::nullopt;
  }

  void answer(const Json& record) {
    const Json& value = record.at("value");
    const std::string questionnaire = record.at("questionnaire").get<std::string>();
    const bool belongs = !now_.empty() || after_condition_.contains(questionnaire);
    const std::string& condition = now_.empty() ? last_ : now_;
    if (!value.is_number() || !belongs || condition.empty()) return;
    const std::string name = questionnaire + "." + record.at("item").get<std::string>();
    by_condition[condition].values[name].push_back(value.get<double>());
  }

  std::set<std::string> after_condition_;
  std::string now_, last_;  // condition
};

std::optional<double> value_of(const Known& measure, const Gathered& here) {
  if (measure.name == kWalked || measure.name == kSpoken) {
    if (here.seconds <= 0) return std::nullopt;
    return measure.name == kWalked ? 60 * here.walked_m / here.seconds
                                   : here.spoken_s / here.seconds;
  }
  const auto found = here.values.find(measure.name);
  if (found == here.values.end()) return std::nullopt;
  return measure.is_median ? median_of(found->second) : mean_of(found->second);
}

/// The copy of the plan that was written last.
Result<StudyPlan> newest_plan(const fs::path& folder) {
  std::optional<fs::path> newest;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / "plans", error)) {
    if (!newest || fs::last_write_time(entry.path(), error) > fs::last_write_time(*newest, error))
      newest = entry.path();
  }
  if (!newest)
    return Error{ErrorCode::kNotFound, folder.string() + " has no copy of the study's plan"};
  return load_plan(*newest);
}

}  // namespace

Summary summary_of(const std::vector<double>& values) {
  Summary summary{.count = values.size()};
  if (values.empty()) return summary;
  summary.mean = mean_of(values);
  if (values.size() < 2) return summary;
  double squares = 0;
  for (const double value : values) squares += (value - summary.mean) * (value - summary.mean);
  const auto n = static_cast<double>(values.size());
  summary.deviation = std::sqrt(squares / (n - 1));
  summary.half_width = student_t(values.size() - 1) * summary.deviation / std::sqrt(n);
  return summary;
}

ComparisonSummary comparison_summary(std::string name, std::size_t answers, std::size_t correct) {
  ComparisonSummary summary{.name = std::move(name), .answers = answers, .correct = correct};
  if (answers == 0) return summary;
  const auto n = static_cast<double>(answers);
  const double share = static_cast<double>(correct) / n, z2 = kNormal * kNormal;
  const double centre = (share + z2 / (2 * n)) / (1 + z2 / n);
  const double half =
      kNormal * std::sqrt(share * (1 - share) / n + z2 / (4 * n * n)) / (1 + z2 / n);
  summary.low_share = std::max(0.0, centre - half);
  summary.high_share = std::min(1.0, centre + half);
  return summary;
}

Result<ConditionSummary> summarise(const StudyFolder& study) {
  const auto plan = newest_plan(study.path());
  if (!plan) return plan.error();
  ConditionSummary summary{.study = plan->name,
                           .title = plan->title.empty() ? plan->name : plan->title,
                           .conditions = {},
                           .measures = {},
                           .comparisons = {}};
  std::map<std::string, std::pair<std::size_t, std::size_t>> compared;
  for (const Condition& condition : plan->conditions) summary.conditions.push_back(condition.name);
  const std::vector<Known> known = measures_of(*plan);
  for (const Known& each : known) summary.measures.push_back({each.name, each.title, each.unit});
  for (const std::string& id : study.participants()) {
    const auto log = study.log(id);
    if (!log) return log.error();
    SessionReader reader(*plan);
    for (const Json& record : log->records) reader.take(record);
    bool is_known = !reader.comparisons.empty();
    for (const auto& [name, counts] : reader.comparisons) {
      compared[name].first += counts.first;
      compared[name].second += counts.second;
    }
    for (const auto& [condition, gathered] : reader.by_condition) {
      for (std::size_t i = 0; i < known.size(); ++i) {
        const auto value = value_of(known[i], gathered);
        if (value) summary.measures[i].values[condition][id] = *value;
        is_known = is_known || value;
      }
    }
    summary.participants += is_known;
  }
  for (const Comparison& comparison : plan->comparisons) {
    const auto [answers, correct] = compared[comparison.name];
    if (answers > 0)
      summary.comparisons.push_back(comparison_summary(comparison.name, answers, correct));
  }
  std::erase_if(summary.measures, [](const Measure& measure) { return measure.values.empty(); });
  return summary;
}

}  // namespace roomcast::study
