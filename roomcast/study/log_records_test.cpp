// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/log_records.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::study {
namespace {

using Json = nlohmann::json;

Json some_record(const LogKind& kind) {
  Json record = {{"kind", kind.name}, {"t", 1.5}};
  for (const LogField& field : kind.fields) {
    if (field.type == FieldType::kFlag) record[std::string(field.name)] = true;
    if (field.type == FieldType::kText) record[std::string(field.name)] = "text";
    if (field.type == FieldType::kNumber || field.type == FieldType::kAnswer)
      record[std::string(field.name)] = 3;
  }
  return record;
}

TEST(LogRecords, of_every_kind_are_taken_when_they_are_whole) {
  for (const LogKind& kind : log_kinds()) {
    const Json whole = some_record(kind);
    EXPECT_TRUE(check_record(whole).ok()) << kind.name;
    for (const auto& [key, value] : whole.items()) {
      Json without = whole;
      without.erase(key);
      EXPECT_FALSE(check_record(without).ok()) << kind.name << " without " << key;
      Json wrong = whole;
      wrong[key] = Json::array();
      EXPECT_FALSE(check_record(wrong).ok()) << kind.name << " with a wrong " << key;
    }
    Json more = whole;
    more["more"] = 1;
    EXPECT_FALSE(check_record(more).ok()) << kind.name;
  }
}

TEST(LogRecords, have_bounded_numbers_and_texts) {
  Json pose = some_record(*find_kind("poses"));
  pose["x"] = 1e300;
  EXPECT_FALSE(check_record(pose).ok());
  pose["x"] = nullptr;
  EXPECT_FALSE(check_record(pose).ok());
  Json answer = some_record(*find_kind("answers"));
  answer["value"] = "words";
  EXPECT_TRUE(check_record(answer).ok());
  answer["value"] = std::string(kMaxRecordText + 1, 'x');
  EXPECT_FALSE(check_record(answer).ok());
  answer["value"] = true;
  EXPECT_FALSE(check_record(answer).ok());
  answer["value"] = 1;
  answer["t"] = -1;
  EXPECT_FALSE(check_record(answer).ok());
}

TEST(LogRecords, that_are_something_else_are_refused_with_a_sentence) {
  for (const Json& other :
       {Json(), Json(1), Json::array(), Json::object(), Json{{"kind", "secrets"}, {"t", 1}}})
    EXPECT_FALSE(check_record(other).error().message.empty());
}

}  // namespace
}  // namespace roomcast::study
