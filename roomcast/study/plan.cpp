// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/plan.h"

#include <nlohmann/json.hpp>

namespace roomcast::study {
namespace {

using Json = nlohmann::json;

Json condition_json(const Condition& condition) {
  return {{"name", condition.name},  {"seconds", condition.seconds},
          {"room", condition.room},  {"instruction", condition.instruction},
          {"mode", condition.mode},  {"latency_ms", condition.latency_ms},
          {"fps", condition.fps},    {"sensors_off", condition.sensors_off},
          {"voice", condition.voice}};
}

Json questionnaire_json(const Questionnaire& questions) {
  Json items = Json::array();
  for (const QuestionItem& item : questions.items) {
    items.push_back({{"name", item.name},
                     {"text", item.text},
                     {"kind", name_of(item.kind)},
                     {"points", item.points},
                     {"labels", item.labels},
                     {"choices", item.choices},
                     {"required", item.required}});
  }
  return {{"name", questions.name},   {"title", questions.title},
          {"intro", questions.intro}, {"before", questions.before},
          {"after", questions.after}, {"after_condition", questions.after_condition},
          {"at_s", questions.at_s},   {"items", std::move(items)}};
}

Json comparison_json(const Comparison& comparison) {
  return {{"name", comparison.name},       {"title", comparison.title},
          {"intro", comparison.intro},     {"question", comparison.question},
          {"seconds", comparison.seconds}, {"before", comparison.before},
          {"after", !comparison.before},   {"pairs", Json::array()}};
}

constexpr std::string_view kExample = R"([study]
name = "delay"
title = "Looking around in a remote room"
room = "lab"                    # of the hub; conditions may name others
order = "balanced"              # or "fixed", "random"
participants = 24               # at most
consent = """
You will look around in a room that cameras show, for about five minutes. We keep where you
look, when you speak (not what you say) and your answers, under a number instead of your name.
You can stop at any time by closing the page. To have your data erased, tell us your number.
"""
thanks = "Thank you! Please tell the person who invited you that you are done."

[[condition]]
name = "live"
seconds = 120
instruction = "Walk around and find the red cup."

[[condition]]
name = "late"
seconds = 120
instruction = "Walk around and find the red cup."
latency_ms = 400                # added to all that comes from the hub
# mode = "points"               # or "mesh", "blend"
# fps = 10                      # pictures a second at most
# sensors_off = ["s1"]
# voice = false
# room = "lab-2mbit"            # where the same sensors send with another codec or rate

[[questionnaire]]
name = "presence"
title = "How it was"
when = ["after-condition"]      # or "before", "after"; at_s = [60] asks within a condition

  [[questionnaire.item]]
  name = "there"
  text = "I had the feeling of being in that room."
  points = 7
  labels = ["not at all", "very much"]

  [[questionnaire.item]]
  name = "found"
  text = "Did you find the cup?"
  choices = ["yes", "no"]

  [[questionnaire.item]]
  name = "remarks"
  text = "Is there anything you want to tell us?"
  kind = "text"
  required = false

# Photographs beside drawn views of the same places: files of the same name in two folders.
# [[comparison]]
# name = "believable"
# real = "photographs"
# drawn = "drawn"
)";

}  // namespace

std::string_view name_of(ConditionOrder order) {
  switch (order) {
    case ConditionOrder::kBalanced:
      return "balanced";
    case ConditionOrder::kFixed:
      return "fixed";
    case ConditionOrder::kRandom:
      break;
  }
  return "random";
}

std::string_view name_of(QuestionItem::Kind kind) {
  using Kind = QuestionItem::Kind;
  switch (kind) {
    case Kind::kScale:
      return "scale";
    case Kind::kChoice:
      return "choice";
    case Kind::kNumber:
      return "number";
    case Kind::kText:
      break;
  }
  return "text";
}

Json to_json(const StudyPlan& plan) {
  Json conditions = Json::array(), questionnaires = Json::array(), comparisons = Json::array();
  for (const Condition& condition : plan.conditions)
    conditions.push_back(condition_json(condition));
  for (const Questionnaire& questions : plan.questionnaires)
    questionnaires.push_back(questionnaire_json(questions));
  for (const Comparison& comparison : plan.comparisons)
    comparisons.push_back(comparison_json(comparison));
  return {{"name", plan.name},
          {"comparisons", std::move(comparisons)},
          {"title", plan.title.empty() ? plan.name : plan.title},
          {"room", plan.room},
          {"consent", plan.consent},
          {"thanks", plan.thanks},
          {"conditions", std::move(conditions)},
          {"questionnaires", std::move(questionnaires)}};
}

std::string_view example_plan() {
  return kExample;
}

}  // namespace roomcast::study
