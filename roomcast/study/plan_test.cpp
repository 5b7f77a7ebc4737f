// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/plan.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/io/file_bytes.h"

namespace roomcast::study {
namespace {

using testing::HasSubstr;

constexpr char kSmallest[] = R"([study]
name = "s"
consent = "We keep your answers."
[[condition]]
name = "one"
)";

/// "4: the sentence" of each fault.
std::vector<std::string> faults_of(const std::string& toml) {
  std::vector<std::string> faults;
  for (const auto& [line, sentence] : read_plan(toml).faults)
    faults.push_back(std::to_string(line) + ": " + sentence);
  return faults;
}

std::string only_fault(const std::string& more) {
  const auto faults = faults_of(kSmallest + more);
  EXPECT_EQ(faults.size(), 1u) << more << testing::PrintToString(faults);
  return faults.empty() ? "" : faults.front();
}

TEST(StudyPlan, the_example_is_one) {
  const ReadPlan read = read_plan(example_plan());
  EXPECT_TRUE(read.faults.empty()) << read.faults.front().sentence;
  EXPECT_EQ(read.plan.name, "delay");
  ASSERT_EQ(read.plan.conditions.size(), 2u);
  EXPECT_EQ(read.plan.conditions[1].latency_ms, 400);
  EXPECT_EQ(read.plan.conditions[0].seconds, 120);
  EXPECT_TRUE(read.plan.conditions[0].voice);
  ASSERT_EQ(read.plan.questionnaires.size(), 1u);
  EXPECT_TRUE(read.plan.questionnaires[0].after_condition);
  EXPECT_FALSE(read.plan.questionnaires[0].before);
  ASSERT_EQ(read.plan.questionnaires[0].items.size(), 3u);
  EXPECT_EQ(read.plan.questionnaires[0].items[1].kind, QuestionItem::Kind::kChoice);
  EXPECT_FALSE(read.plan.questionnaires[0].items[2].required);
}

TEST(StudyPlan, everything_that_can_be_said_is_read) {
  const ReadPlan read = read_plan(std::string(kSmallest) + R"(mode = "points"
fps = 7.5
sensors_off = ["s1", "left camera"]
voice = false
room = "other"
instruction = "Go."
[[questionnaire]]
name = "q"
at_s = [30, 10.5]
when = ["before", "after"]
[[questionnaire.item]]
name = "i"
text = "How many?"
kind = "number"
)");
  ASSERT_TRUE(read.faults.empty()) << read.faults.front().sentence;
  const Condition& condition = read.plan.conditions[0];
  EXPECT_EQ(condition.mode, "points");
  EXPECT_EQ(condition.fps, 7.5);
  EXPECT_EQ(condition.sensors_off, (std::vector<std::string>{"s1", "left camera"}));
  EXPECT_FALSE(condition.voice);
  EXPECT_EQ(condition.room, "other");
  EXPECT_EQ(read.plan.questionnaires[0].at_s, (std::vector<double>{10.5, 30}));
  const nlohmann::json json = to_json(read.plan);
  EXPECT_EQ(json["conditions"][0]["fps"], 7.5);
  EXPECT_EQ(json["questionnaires"][0]["items"][0]["kind"], "number");
  EXPECT_EQ(json["consent"], "We keep your answers.");
}

TEST(StudyPlan, mistakes_are_told_with_their_line) {
  EXPECT_THAT(only_fault("colour = 1\n"),
              HasSubstr("6: a condition has no \"colour\"; it may have: fps"));
  EXPECT_THAT(only_fault("seconds = \"long\"\n"), HasSubstr("6: this must be a number from 1 to"));
  EXPECT_THAT(only_fault("seconds = 0\n"), HasSubstr("6: "));
  EXPECT_THAT(only_fault("seconds = nan\n"), HasSubstr("6: "));
  EXPECT_THAT(only_fault("mode = \"cubist\"\n"), HasSubstr("\"blend\", \"mesh\", \"points\""));
  EXPECT_THAT(only_fault("voice = \"no\"\n"), HasSubstr("true or false"));
  EXPECT_THAT(only_fault("sensors_off = \"s1\"\n"), HasSubstr("list of texts"));
  EXPECT_THAT(only_fault("[[condition]]\nname = \"one\"\n"),
              HasSubstr("two conditions named \"one\""));
  EXPECT_THAT(only_fault("[[condition]]\nseconds = 5\n"),
              HasSubstr("6: a condition needs \"name\""));
  EXPECT_THAT(only_fault("[[condition]]\nname = \"a/b\"\n"), HasSubstr("\"a/b\" is no name"));
  EXPECT_THAT(only_fault("[questionnaire]\nname = \"q\"\n"), HasSubstr("[[questionnaire]]"));
  EXPECT_THAT(only_fault("more = ]\n"), HasSubstr("6: this is not TOML"));
}

TEST(StudyPlan, questionnaires_have_times_items_and_kinds_that_fit) {
  const std::string head = "[[questionnaire]]\nname = \"q\"\n";
  const std::string item = "[[questionnaire.item]]\nname = \"i\"\ntext = \"?\"\n";
  EXPECT_THAT(only_fault(head + item), HasSubstr("never shown"));
  EXPECT_THAT(only_fault(head + "when = [\"soon\"]\n" + item), HasSubstr("\"soon\" is no time"));
  EXPECT_THAT(only_fault(head + "when = [\"after\"]\n"), HasSubstr("needs \"item\""));
  EXPECT_THAT(only_fault(head + "at_s = [60]\n" + item), HasSubstr("no condition is that long"));
  const std::string whole = head + "when = [\"after\"]\n" + item;
  EXPECT_THAT(only_fault(whole + "labels = [\"a\", \"b\", \"c\"]\n"), HasSubstr("2 labels"));
  EXPECT_THAT(only_fault(whole + "choices = [\"a\"]\n"), HasSubstr("at least two"));
  EXPECT_THAT(only_fault(whole + "kind = \"text\"\nchoices = [\"a\", \"b\"]\n"),
              HasSubstr("only items of the kind \"choice\""));
  EXPECT_THAT(only_fault(whole + item), HasSubstr("two items named"));
}

TEST(StudyPlan, all_mistakes_are_told_at_once_in_order) {
  const auto faults = faults_of("[study]\nname = 7\n[[condition]]\nfps = -1\n");
  ASSERT_EQ(faults.size(), 4u) << testing::PrintToString(faults);
  EXPECT_THAT(faults[0], HasSubstr("1: [study] needs \"consent\""));
  EXPECT_THAT(faults[1], HasSubstr("2: this must be text"));
  EXPECT_EQ(faults_of("").size(), 2u);
  EXPECT_THAT(faults_of("study = 1")[0], HasSubstr("no [[condition]]"));
}

TEST(StudyPlan, without_consent_there_is_none) {
  EXPECT_THAT(faults_of("[study]\nname = \"s\"\nconsent = \"\"\n[[condition]]\nname = \"one\"\n"),
              testing::ElementsAre(HasSubstr("3: without a text that people agree to")));
}

TEST(StudyPlan, a_file_with_a_mistake_is_refused_by_name_and_line) {
  const TemporaryFolder folder;
  ASSERT_TRUE(io::write_file(folder / "plan.toml", std::string(kSmallest) + "fps = 0\n").ok());
  const auto plan = load_plan(folder / "plan.toml");
  EXPECT_EQ(plan.error().code, ErrorCode::kMalformed);
  EXPECT_THAT(plan.error().message, HasSubstr("plan.toml, line 6: this must be a number"));
  EXPECT_EQ(load_plan(folder / "none.toml").error().code, ErrorCode::kNotFound);
}

TEST(Plan, has_comparisons_of_pictures) {
  const std::string head =
      "[study]\nname = \"s\"\nconsent = \"c\"\n[[condition]]\nname = \"one\"\n";
  const auto read = read_plan(head + R"([[comparison]]
name = "c"
real = "photographs"
drawn = "drawn"
when = "before"
seconds = 3
)");
  ASSERT_TRUE(read.faults.empty()) << read.faults.front().sentence;
  const Comparison& comparison = read.plan.comparisons.at(0);
  EXPECT_EQ(comparison.real, "photographs");
  EXPECT_TRUE(comparison.before);
  EXPECT_EQ(to_json(read.plan)["comparisons"][0]["question"], "Which of the two is a photograph?");
  const auto wrong = read_plan(head + "[[comparison]]\nname = \"c\"\nreal = \"r\"\nwhen = 3\n");
  ASSERT_EQ(wrong.faults.size(), 2u);
  EXPECT_EQ(wrong.faults[0].line, 6u);
  EXPECT_EQ(wrong.faults[1].line, 9u);
}

}  // namespace
}  // namespace roomcast::study
