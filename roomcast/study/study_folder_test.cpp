// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/study_folder.h"

#include <fstream>

#include <gmock/gmock.h>

#include "roomcast/study/study_fixture.h"

namespace roomcast::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::json;

class StudyFolderTest : public StudyFixture {};

TEST_F(StudyFolderTest, keeps_consent_and_order_of_each_participant) {
  auto study = create();
  const auto first = study.enroll(plan, "k1", kNow);
  ASSERT_TRUE(first.ok()) << first.error().message;
  EXPECT_EQ(first->id, "P001");
  EXPECT_THAT(first->order, ElementsAre("one", "two"));
  EXPECT_EQ(study.enroll(plan, "k2", kNow)->order, (std::vector<std::string>{"two", "one"}));
  const auto kept = StudyFolder::open(path)->participant("P001");
  ASSERT_TRUE(kept.ok()) << kept.error().message;
  EXPECT_EQ(kept->consent, "We keep your answers.");
  EXPECT_EQ(kept->consented_at, "2027-01-15T08:00:00.000Z");
  EXPECT_EQ(kept->key_sha256, "k1");
  EXPECT_THAT(study.participants(), ElementsAre("P001", "P002"));
}

TEST_F(StudyFolderTest, is_full_when_the_plan_says_so) {
  auto study = create();
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(study.enroll(plan, "k", kNow).ok());
  const auto refused = study.enroll(plan, "k", kNow);
  EXPECT_EQ(refused.error().code, ErrorCode::kUnavailable);
  EXPECT_THAT(refused.error().message, HasSubstr("3 participants"));
}

TEST_F(StudyFolderTest, takes_each_batch_once_and_knows_how_far_a_session_is) {
  auto study = create();
  (void)study.enroll(plan, "k", kNow);
  const Json first = {step(0, 0, "one", true), speech(1, true)};
  ASSERT_TRUE(study.append("P001", 1, first).ok());
  ASSERT_TRUE(study.append("P001", 1, first).ok()) << "sent again, because the answer was lost";
  ASSERT_TRUE(study.append("P001", 2, Json::array({step(60, 0, "one", false)})).ok());
  auto reopened = *StudyFolder::open(path);
  for (StudyFolder* known : {&study, &reopened}) {
    const auto progress = known->progress("P001");
    ASSERT_TRUE(progress.ok());
    EXPECT_EQ(progress->batch, 2u);
    EXPECT_EQ(progress->steps, 1u);
    EXPECT_EQ(progress->t, 60);
    EXPECT_EQ(known->log("P001")->records.size(), 3u);
  }
}

TEST_F(StudyFolderTest, a_batch_that_a_crash_cut_off_counts_when_it_comes_again) {
  {
    auto study = create();
    (void)study.enroll(plan, "k", kNow);
    ASSERT_TRUE(study.append("P001", 1, Json::array({speech(1, true)})).ok());
  }
  std::ofstream(path / "participants/P001/log.jsonl", std::ios::app)
      << speech(2, false).dump() << "\n{\"kind\": \"spee\n";
  auto study = *StudyFolder::open(path);
  EXPECT_EQ(study.log("P001")->records.size(), 1u);
  ASSERT_TRUE(study.append("P001", 2, Json::array({speech(2, false), speech(3, true)})).ok());
  EXPECT_EQ(StudyFolder::open(path)->log("P001")->records.size(), 3u);
}

TEST_F(StudyFolderTest, refuses_records_that_are_none_and_writes_nothing_of_them) {
  auto study = create();
  (void)study.enroll(plan, "k", kNow);
  EXPECT_EQ(study.append("P001", 1, Json::array({speech(1, true), Json{{"kind", "secrets"}}}))
                .error()
                .code,
            ErrorCode::kMalformed);
  EXPECT_EQ(study.append("P001", 1, Json::object()).error().code, ErrorCode::kMalformed);
  EXPECT_TRUE(study.log("P001")->records.empty());
  for (const char* id : {"P009", "", "../..", "P00x", "Q001"})
    EXPECT_EQ(study.append(id, 1, Json::array({speech(1, true)})).error().code,
              ErrorCode::kNotFound)
        << id;
}

TEST_F(StudyFolderTest, erases_all_of_a_participant_whose_number_is_not_given_again) {
  auto study = create();
  (void)study.enroll(plan, "k", kNow);
  (void)study.enroll(plan, "k", kNow);
  ASSERT_TRUE(study.append("P002", 1, Json::array({answer(1, "a secret")})).ok());
  auto other = *StudyFolder::open(path);  // another program
  ASSERT_TRUE(other.erase("P002", kNow).ok());
  EXPECT_EQ(other.erase("P002", kNow).error().code, ErrorCode::kNotFound);
  EXPECT_EQ(study.append("P002", 2, Json::array({speech(1, true)})).error().code,
            ErrorCode::kNotFound);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(text.find("a secret"), std::string::npos) << entry.path();
  }
  EXPECT_EQ(study.enroll(plan, "k", kNow)->id, "P003");
}

TEST_F(StudyFolderTest, of_another_study_is_not_used) {
  (void)create();
  StudyPlan other = plan;
  other.name = "other";
  const auto refused = StudyFolder::create(path, other, "", std::string(64, 'b'));
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalidArgument);
  EXPECT_THAT(refused.error().message, HasSubstr("belongs to the study \"s\""));
  EXPECT_EQ(StudyFolder::open(folder / "none").error().code, ErrorCode::kNotFound);
}

TEST_F(StudyFolderTest, goes_on_with_a_changed_plan_and_keeps_both) {
  auto study = create();
  (void)study.enroll(plan, "k", kNow);
  auto again = *StudyFolder::create(path, plan, "name = 2", std::string(64, 'b'));
  EXPECT_EQ(again.enroll(plan, "k", kNow)->plan_sha256, std::string(64, 'b'));
  EXPECT_TRUE(std::filesystem::exists(path / "plans/aaaaaaaaaaaaaaaa.toml"));
  EXPECT_TRUE(std::filesystem::exists(path / "plans/bbbbbbbbbbbbbbbb.toml"));
}

TEST_F(StudyFolderTest, that_is_damaged_is_told) {
  auto study = create();
  (void)study.enroll(plan, "k", kNow);
  std::ofstream(path / "participants/P001/participant.json") << "{\"id\": 7}";
  EXPECT_EQ(study.participant("P001").error().code, ErrorCode::kMalformed);
  std::ofstream(path / "study.json") << "no";
  EXPECT_EQ(StudyFolder::open(path).error().code, ErrorCode::kMalformed);
}

}  // namespace
}  // namespace roomcast::study
