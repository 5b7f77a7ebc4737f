// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/log_records.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace roomcast::study {
namespace {

using Json = nlohmann::json;
using enum FieldType;

constexpr std::array kStepFields = {
    LogField{"step", kNumber, "", "number of the step in this participant's session, from 0"},
    LogField{"what", kText, "", "condition, questionnaire, or comparison"},
    LogField{"name", kText, "", "its name in the plan"},
    LogField{"begins", kFlag, "", "true when it begins, false when it ends"}};
constexpr std::array kPoseFields = {
    LogField{"x", kNumber, "m", "head, world frame; y is up"},
    LogField{"y", kNumber, "m", "head, world frame"},
    LogField{"z", kNumber, "m", "head, world frame"},
    LogField{"qx", kNumber, "",
             "unit quaternion, world from head: x right, y up, -z where it looks"},
    LogField{"qy", kNumber, "", ""},
    LogField{"qz", kNumber, "", ""},
    LogField{"qw", kNumber, "", ""}};
constexpr std::array kFigureFields = {
    LogField{"fps", kNumber, "1/s", "frame sets drawn in the last second"},
    LogField{
        "latency_ms", kNumber, "ms",
        "capture to drawing, median of the last second; with what the condition adds; 0: unknown"},
    LogField{"mbit", kNumber, "Mbit/s", "received in the last second"},
    LogField{"clock_error_ms", kNumber, "ms", "bound on the error of the latency; 0: unknown"}};
constexpr std::array kSensorFields = {
    LogField{"sensor", kText, "", "name of the sensor"},
    LogField{"online", kFlag, "", "it is connected"},
    LogField{"shown", kFlag, "", "it is drawn in this condition"},
    LogField{"frames", kNumber, "", "frames of it decoded since the page was loaded"},
    LogField{"age_ms", kNumber, "ms", "age of its newest frame when this was written; 0: unknown"}};
constexpr std::array kSpeechFields = {
    LogField{"on", kFlag, "", "true when the participant begins to be heard, false at the end"}};
constexpr std::array kAnswerFields = {
    LogField{"questionnaire", kText, "", "name of the questionnaire in the plan"},
    LogField{"item", kText, "", "name of the item"},
    LogField{"value", kAnswer, "", "the answer: a number, or text; empty if it was left out"},
    LogField{"at_s", kNumber, "s",
             "time within the condition at which it was asked; 0: not within one"},
    LogField{"after_s", kNumber, "s", "from showing the questionnaire to sending it"}};
constexpr std::array kComparisonFields = {
    LogField{"comparison", kText, "", "name of the comparison in the plan"},
    LogField{"pair", kText, "", "name of the two files"},
    LogField{"left", kText, "", "which of the two was on the left: real, or drawn"},
    LogField{"chosen", kText, "", "which one the participant chose: left, or right"},
    LogField{"correct", kFlag, "", "true: the photograph was chosen"},
    LogField{"after_s", kNumber, "s", "from showing the pair to choosing"}};
constexpr std::array kPageFields = {
    LogField{
        "what", kText, "",
        "visible (the page can be seen), connected (to the hub), loaded (again, after the first "
        "time), trouble (the page cannot do what the condition asks)"},
    LogField{"on", kFlag, "", "true when it begins, false when it ends"},
    LogField{"note", kText, "", "details for people"}};

constexpr std::array kKinds = {
    LogKind{"steps", "begin and end of conditions, questionnaires and comparisons", kStepFields},
    LogKind{"poses", "where the participant's head is, ten times a second", kPoseFields},
    LogKind{"figures", "what the participant got, once a second", kFigureFields},
    LogKind{"sensors", "what the participant got of each sensor, once a second", kSensorFields},
    LogKind{"speech", "when the participant spoke; never what", kSpeechFields},
    LogKind{"answers", "answers to questionnaires", kAnswerFields},
    LogKind{"comparisons", "which picture of a pair was taken for the photograph",
            kComparisonFields},
    LogKind{"page", "what happened to the page", kPageFields}};

Error wrong_record(std::string sentence) {
  return {ErrorCode::kMalformed, std::move(sentence)};
}

bool is_number(const Json& value) {
  return value.is_number() && std::abs(value.get<double>()) <= kMaxRecordNumber;
}

bool is_text(const Json& value) {
  return value.is_string() && value.get_ref<const std::string&>().size() <= kMaxRecordText;
}

bool fits(const Json& value, FieldType type) {
  switch (type) {
    case kNumber:
      return is_number(value);
    case kFlag:
      return value.is_boolean();
    case kText:
      return is_text(value);
    case kAnswer:
      break;
  }
  return is_number(value) || is_text(value);
}

}  // namespace

std::string_view name_of(FieldType type) {
  switch (type) {
    case kNumber:
      return "number";
    case kFlag:
      return "true or false";
    case kText:
      return "text";
    case kAnswer:
      break;
  }
  return "number or text";
}

std::span<const LogKind> log_kinds() {
  return kKinds;
}

const LogKind* find_kind(std::string_view name) {
  const auto found = std::ranges::find(kKinds, name, &LogKind::name);
  return found == kKinds.end() ? nullptr : &*found;
}

Status check_record(const Json& record) {
  if (!record.is_object()) return wrong_record("a record of a session is an object");
  const auto name = record.find("kind"), time = record.find("t");
  const LogKind* kind = name != record.end() && name->is_string()
                            ? find_kind(name->get_ref<const std::string&>())
                            : nullptr;
  if (kind == nullptr) return wrong_record("a record of a session has no known \"kind\"");
  if (time == record.end() || !is_number(*time) || time->get<double>() < 0)
    return wrong_record("a record of a session has no time \"t\"");
  for (const LogField& field : kind->fields) {
    const auto value = record.find(field.name);
    if (value == record.end() || !fits(*value, field.type))
      return wrong_record(fmt::format("a record of the kind \"{}\" needs \"{}\", a {}", kind->name,
                                      field.name, name_of(field.type)));
  }
  if (record.size() != kind->fields.size() + 2)
    return wrong_record(
        fmt::format("a record of the kind \"{}\" has an unknown field", kind->name));
  return {};
}

std::optional<std::string> condition_after(const Json& record) {
  if (record.at("kind") != "steps" || record.at("what") != "condition") return std::nullopt;
  return record.at("begins") == true ? record.at("name").get<std::string>() : std::string();
}

}  // namespace roomcast::study
