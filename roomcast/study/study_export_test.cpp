// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/study_export.h"

#include <fstream>
#include <set>
#include <sstream>

#include <gmock/gmock.h>

#include "roomcast/study/study_fixture.h"

namespace roomcast::study {
namespace {

using testing::ElementsAre;

class StudyExportTest : public StudyFixture {
 protected:
  std::vector<std::string> lines(const std::string& name) const {
    std::ifstream file(folder / "csv" / name);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) {
      if (line.ends_with('\r')) line.pop_back();
      lines.push_back(line);
    }
    return lines;
  }
};

TEST_F(StudyExportTest, has_every_record_with_participant_and_condition) {
  auto study = create();
  (void)study.enroll(plan, "k", kNow);
  (void)study.enroll(plan, "k", kNow);
  ASSERT_TRUE(study
                  .append("P002", 1,
                          {speech(0.5, true), step(1, 0, "two", true), speech(2.25, false),
                           answer(3, "yes, \"both\""), step(4, 0, "two", false), answer(5, 7)})
                  .ok());
  const auto done = export_csv(study, folder / "csv");
  ASSERT_TRUE(done.ok()) << done.error().message;
  EXPECT_EQ(done->participants, 2u);
  EXPECT_EQ(done->rows.at("speech.csv"), 2u);
  EXPECT_EQ(done->rows.at("poses.csv"), 0u);
  EXPECT_THAT(lines("speech.csv"),
              ElementsAre("participant,t_s,condition,on", "P002,0.5,,true", "P002,2.25,two,false"));
  EXPECT_THAT(lines("steps.csv"),
              ElementsAre("participant,t_s,condition,step,what,name,begins",
                          "P002,1,two,0,condition,two,true", "P002,4,two,0,condition,two,false"));
  EXPECT_THAT(lines("answers.csv"),
              ElementsAre("participant,t_s,condition,questionnaire,item,value,at_s,after_s",
                          "P002,3,two,q,i,\"yes, \"\"both\"\"\",0,2.5", "P002,5,,q,i,7,0,2.5"));
  EXPECT_THAT(lines("participants.csv"),
              ElementsAre("participant,number,consented_at,plan,order,steps,seconds",
                          "P001,1,2027-01-15T08:00:00.000Z,aaaaaaaaaaaaaaaa,one two,0,0.000",
                          "P002,2,2027-01-15T08:00:00.000Z,aaaaaaaaaaaaaaaa,two one,1,5.000"));
}

TEST_F(StudyExportTest, says_what_every_column_means) {
  (void)create();
  ASSERT_TRUE(export_csv(create(), folder / "csv").ok());
  std::set<std::string> described;
  for (const std::string& line : lines("data_dictionary.csv")) {
    std::istringstream cells(line);
    std::string file, column;
    std::getline(cells, file, ',');
    std::getline(cells, column, ',');
    described.insert(file + " " + column);
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder / "csv")) {
    const std::string name = entry.path().filename().string();
    if (name == "data_dictionary.csv") continue;
    std::istringstream columns(lines(name).at(0));
    for (std::string column; std::getline(columns, column, ',');)
      EXPECT_TRUE(described.contains(name + " " + column)) << name << " " << column;
  }
}

TEST_F(StudyExportTest, writes_over_no_folder) {
  const auto study = create();
  ASSERT_TRUE(export_csv(study, folder / "csv").ok());
  EXPECT_EQ(export_csv(study, folder / "csv").error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::study
