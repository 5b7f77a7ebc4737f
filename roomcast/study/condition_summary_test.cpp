// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/condition_summary.h"

#include <gtest/gtest.h>

#include "roomcast/study/study_fixture.h"

namespace roomcast::study {
namespace {

using Json = nlohmann::json;

constexpr const char* kComparedPlan = R"([study]
name = "s"
consent = "yes"
[[condition]]
name = "one"
[[condition]]
name = "two"
[[questionnaire]]
name = "q"
when = ["after-condition"]
[[questionnaire.item]]
name = "i"
text = "How was it?"
[[questionnaire]]
name = "end"
when = ["after"]
[[questionnaire.item]]
name = "all"
text = "And all in all?"
)";

class ConditionSummaryTest : public StudyFixture {
 protected:
  static Json pose(double t, double x) {
    return {{"kind", "poses"}, {"t", t},  {"x", x},  {"y", 1.6}, {"z", 0},
            {"qx", 0},         {"qy", 0}, {"qz", 0}, {"qw", 1}};
  }
  static Json figure(double t, double latency_ms) {
    return {{"kind", "figures"},  {"t", t}, {"fps", 30}, {"mbit", 2}, {"latency_ms", latency_ms},
            {"clock_error_ms", 1}};
  }
  static Json named(Json record, const char* questionnaire, const char* item) {
    record["questionnaire"] = questionnaire;
    record["item"] = item;
    return record;
  }
  const Measure* find(const ConditionSummary& summary, const std::string& name) const {
    for (const Measure& measure : summary.measures)
      if (measure.name == name) return &measure;
    return nullptr;
  }
};

TEST_F(ConditionSummaryTest, gives_each_participant_a_value_in_each_condition) {
  auto study = create_from(kComparedPlan);
  (void)study.enroll(plan, "k", kNow);
  ASSERT_TRUE(
      study
          .append("P001", 1,
                  {step(0, 0, "one", true), pose(1, 0), pose(2, 3), figure(2, 100), figure(3, 300),
                   figure(4, 120), speech(5, true), speech(8, false), step(60, 0, "one", false),
                   answer(61, 6), step(70, 1, "two", true), speech(75, true),
                   step(80, 1, "two", false), answer(81, 2), named(answer(90, 7), "end", "all")})
          .ok());
  const auto summary = summarise(study);
  ASSERT_TRUE(summary.ok()) << summary.error().message;
  EXPECT_EQ(summary->participants, 1u);
  EXPECT_EQ(summary->conditions, (std::vector<std::string>{"one", "two"}));
  const Measure* answered = find(*summary, "q.i");
  ASSERT_NE(answered, nullptr);
  EXPECT_EQ(answered->title, "How was it?");
  EXPECT_EQ(answered->values.at("one").at("P001"), 6);
  EXPECT_EQ(answered->values.at("two").at("P001"), 2);
  EXPECT_EQ(find(*summary, "end.all"), nullptr);  // of no condition
  EXPECT_EQ(find(*summary, "latency_ms")->values.at("one").at("P001"), 120);
  EXPECT_EQ(find(*summary, "walked_m_min")->values.at("one").at("P001"), 3);
  EXPECT_NEAR(find(*summary, "spoken_share")->values.at("one").at("P001"), 0.05, 1e-9);
  EXPECT_NEAR(find(*summary, "spoken_share")->values.at("two").at("P001"), 0.5, 1e-9);
}

TEST_F(ConditionSummaryTest, counts_photographs_that_were_recognised) {
  auto study = create_from(std::string(kComparedPlan) +
                           "[[comparison]]\nname = \"c\"\nreal = \"r\"\ndrawn = \"d\"\n");
  (void)study.enroll(plan, "k", kNow);
  const auto chose = [](bool correct) {
    return Json{{"kind", "comparisons"}, {"t", 1},         {"comparison", "c"},
                {"pair", "a"},           {"left", "real"}, {"chosen", correct ? "left" : "right"},
                {"correct", correct},    {"after_s", 1.5}};
  };
  ASSERT_TRUE(study.append("P001", 1, {chose(true), chose(false), chose(true)}).ok());
  const auto summary = summarise(study);
  ASSERT_TRUE(summary.ok());
  ASSERT_EQ(summary->comparisons.size(), 1u);
  EXPECT_EQ(summary->comparisons[0].answers, 3u);
  EXPECT_EQ(summary->comparisons[0].correct, 2u);
  EXPECT_EQ(summary->participants, 1u);
}

TEST_F(ConditionSummaryTest, a_comparison_is_no_condition) {
  auto study = create_from(kComparedPlan);
  (void)study.enroll(plan, "k", kNow);
  const auto comparing = [](double t, bool begins) {
    Json record = step(t, 1, "c", begins);
    record["what"] = "comparison";
    return record;
  };
  ASSERT_TRUE(study
                  .append("P001", 1,
                          {step(0, 0, "one", true), step(60, 0, "one", false), comparing(61, true),
                           pose(62, 0), comparing(70, false), answer(71, 6)})
                  .ok());
  const auto summary = summarise(study);
  ASSERT_TRUE(summary.ok());
  const Measure* answered = find(*summary, "q.i");
  ASSERT_NE(answered, nullptr);
  EXPECT_EQ(answered->values.at("one").at("P001"), 6);
  for (const Measure& measure : summary->measures) EXPECT_FALSE(measure.values.contains("c"));
}

TEST_F(ConditionSummaryTest, of_nobody_has_no_measures) {
  const auto summary = summarise(create_from(kComparedPlan));
  ASSERT_TRUE(summary.ok());
  EXPECT_TRUE(summary->measures.empty());
  EXPECT_EQ(summary->participants, 0u);
}

TEST_F(ConditionSummaryTest, needs_a_plan_that_can_be_read) {
  EXPECT_FALSE(summarise(create()).ok());  // its plan is none
}

TEST(Summary, has_the_interval_of_student_s_t) {
  EXPECT_EQ(summary_of({}).count, 0u);
  EXPECT_EQ(summary_of({3}).mean, 3);
  EXPECT_EQ(summary_of({3}).half_width, 0);
  const Summary four = summary_of({1, 2, 3, 4});
  EXPECT_DOUBLE_EQ(four.mean, 2.5);
  EXPECT_NEAR(four.deviation, 1.29099, 1e-5);
  EXPECT_NEAR(four.half_width, 3.182 * 1.29099 / 2, 1e-4);
  std::vector<double> many(100);
  for (std::size_t i = 0; i < many.size(); ++i) many[i] = i % 2 == 0 ? 1 : -1;
  EXPECT_NEAR(summary_of(many).half_width / (summary_of(many).deviation / 10), 1.984, 0.005);
}

TEST(Summary, of_a_comparison_has_wilson_s_interval) {
  const ComparisonSummary none = comparison_summary("c", 0, 0);
  EXPECT_EQ(none.low_share, 0);
  EXPECT_EQ(none.high_share, 1);
  const ComparisonSummary some = comparison_summary("c", 20, 12);
  EXPECT_NEAR(some.low_share, 0.3866, 5e-4);
  EXPECT_NEAR(some.high_share, 0.7812, 5e-4);
  EXPECT_GT(comparison_summary("c", 10, 0).high_share, 0.2);
}

}  // namespace
}  // namespace roomcast::study
