// SPDX-License-Identifier: Apache-2.0
// StudyPlan: what a researcher plans for a study with people: consent, conditions, questionnaires
// (docs/spec/study.md). Read from TOML; every mistake is reported with its line. Plain data.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "roomcast/core/result.h"

namespace roomcast::study {

inline constexpr std::size_t kMaxPlanBytes = 1U << 20U;
inline constexpr std::size_t kMaxConditions = 20;
inline constexpr std::size_t kMaxQuestionnaires = 50;
inline constexpr std::size_t kMaxComparisons = 20;
inline constexpr std::size_t kMaxItems = 200;  // of a questionnaire
inline constexpr std::size_t kMaxTextBytes = 20'000;

/// In which order a participant gets the conditions.
enum class ConditionOrder {
  kBalanced,  // counterbalanced: counterbalance.h
  kFixed,     // as in the plan
  kRandom,    // drawn for each participant
};

/// How the room is shown to a participant for a while. What is empty or 0 is as it is.
struct Condition {
  std::string name;
  double seconds = 60;
  std::string instruction = {};  // shown before
  std::string room = {};         // in which it takes place; empty: the study's
  std::string mode = {};         // blend, mesh, points
  double latency_ms = 0;         // added to all that comes from the hub
  double fps = 0;                // pictures a second at most
  std::vector<std::string> sensors_off = {};
  bool voice = true;
};

struct QuestionItem {
  enum class Kind { kScale, kChoice, kNumber, kText };
  std::string name;
  std::string text;
  Kind kind = Kind::kScale;
  int points = 7;                        // of a scale
  std::vector<std::string> labels = {};  // of a scale: at its ends, or at each point
  std::vector<std::string> choices = {};
  bool required = true;
};

struct Questionnaire {
  std::string name;
  std::string title = {};
  std::string intro = {};
  bool before = false;            // all conditions
  bool after_condition = false;   // each
  bool after = false;             // all
  std::vector<double> at_s = {};  // within each condition, whose time stands still meanwhile
  std::vector<QuestionItem> items = {};
};

/// Pairs of a photograph and a drawn view of the same place: files of the same name in two folders.
struct Comparison {
  std::string name;
  std::string title = {};
  std::string intro = {};
  std::string question = "Which of the two is a photograph?";
  std::string real = {}, drawn = {};  // folders, from that of the plan
  double seconds = 0;                 // for which they are shown; 0: until one is chosen
  bool before = false;                // the conditions; else after them
};

struct StudyPlan {
  std::string name;
  std::string title = {};
  std::string room = {};  // empty: the hub's only one
  std::string consent;
  std::string thanks = {};
  ConditionOrder order = ConditionOrder::kBalanced;
  std::size_t participants = 200;  // at most
  std::vector<Condition> conditions = {};
  std::vector<Questionnaire> questionnaires = {};
  std::vector<Comparison> comparisons = {};
};

[[nodiscard]] std::string_view name_of(ConditionOrder order);
[[nodiscard]] std::string_view name_of(QuestionItem::Kind kind);

struct PlanFault {
  std::size_t line = 0;  // 0: of none
  std::string sentence;
};

/// A plan with faults cannot be used.
struct ReadPlan {
  StudyPlan plan;
  std::vector<PlanFault> faults;  // in order of lines
};

[[nodiscard]] ReadPlan read_plan(std::string_view toml);

/// `file`: where the text is from, for errors. kMalformed as load_plan().
[[nodiscard]] Result<StudyPlan> plan_of(std::string_view toml, const std::filesystem::path& file);

/// kNotFound, kTooLarge; kMalformed with the first fault, as "FILE, line N: ...".
[[nodiscard]] Result<StudyPlan> load_plan(const std::filesystem::path& file);

/// As the hub gives it to pages, but without the pairs of comparisons.
[[nodiscard]] nlohmann::json to_json(const StudyPlan& plan);

/// A plan that shows what can be said in one.
[[nodiscard]] std::string_view example_plan();

}  // namespace roomcast::study
