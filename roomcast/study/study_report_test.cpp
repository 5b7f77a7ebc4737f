// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/study_report.h"

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::study {
namespace {

using testing::HasSubstr;
using testing::Not;

const Measure kScale{.name = "q.i",
                     .title = "How <b>real</b>?",
                     .unit = "",
                     .values = {{"one", {{"P001", 2}, {"P002", 4}}}, {"two", {{"P001", 6}}}}};

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(StudyReport, draws_a_dot_for_each_participant_and_a_row_for_each_condition) {
  const std::string svg = figure_svg(kScale, {"one", "two", "three"});
  EXPECT_EQ(count_of(svg, "<circle"), 3u);
  for (const char* name : {">one<", ">two<", ">three<"}) EXPECT_THAT(svg, HasSubstr(name));
  EXPECT_THAT(svg, HasSubstr("How &lt;b&gt;real&lt;/b&gt;?"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(StudyReport, draws_equal_values_too) {
  const Measure same{
      .name = "fps", .title = "f", .unit = "1/s", .values = {{"one", {{"P001", 5}}}}};
  const std::string svg = figure_svg(same, {"one"});
  EXPECT_THAT(svg, HasSubstr("1/s"));
  Measure none = same;
  none.values["one"]["P001"] = 0;
  EXPECT_THAT(figure_svg(none, {"one"}), Not(HasSubstr(">-")));  // no way is shorter than none
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(StudyReport, writes_page_figures_and_numbers) {
  const TemporaryFolder folder;
  const ConditionSummary summary{.study = "s",
                                 .title = "A & B",
                                 .conditions = {"one", "two"},
                                 .measures = {kScale},
                                 .comparisons = {{"c", 4, 3, 0.3, 0.95}},
                                 .participants = 2};
  ASSERT_TRUE(write_report(summary, folder / "out").ok());
  const std::string page = content(folder / "out" / "report.html");
  EXPECT_THAT(page, HasSubstr("<h1>A &amp; B</h1>"));
  EXPECT_THAT(page, HasSubstr("2 participants"));
  EXPECT_THAT(page, HasSubstr("<tr><th>one<td>2<td>3<td>1.414<td>"));
  EXPECT_THAT(page, HasSubstr("<tr><th>c<td>4<td>3<td>75 %<td>30 to 95 %"));
  EXPECT_THAT(page, Not(HasSubstr("<b>real")));
  EXPECT_THAT(content(folder / "out" / "q.i.svg"), HasSubstr("<svg"));
  EXPECT_THAT(content(folder / "out" / "summary.csv"), HasSubstr("q.i,,two,1,6,0,6,6\r\n"));
  EXPECT_EQ(write_report(summary, folder / "out").error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::study
