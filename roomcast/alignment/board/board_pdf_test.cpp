// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/board/board_pdf.h"

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

TEST(BoardPdf, the_tag_is_as_large_as_the_page_allows) {
  EXPECT_NEAR(tag_side_mm(kA4), 152, 0.1);
  EXPECT_NEAR(tag_side_mm(kA3), 221.6, 0.1);
}

TEST(BoardPdf, the_file_has_the_papers_size_and_its_objects_where_the_table_says) {
  const std::string pdf = board_pdf(kA4).value();
  EXPECT_TRUE(pdf.starts_with("%PDF-1.4\n"));
  EXPECT_TRUE(pdf.ends_with("%%EOF\n"));
  EXPECT_NE(pdf.find("/MediaBox [0 0 595.2756 841.8898]"), std::string::npos);
  const std::size_t table = std::stoul(pdf.substr(pdf.find("startxref\n") + 10));
  ASSERT_EQ(pdf.substr(table, 5), "xref\n");
  std::size_t entry = pdf.find(" 65535 f \n", table) + 10;
  for (int object = 1; object <= 5; ++object, entry += 20) {
    const std::string begins = std::to_string(object) + " 0 obj\n";
    EXPECT_EQ(pdf.substr(std::stoul(pdf.substr(entry, 10)), begins.size()), begins);
  }
}

TEST(BoardPdf, other_tags_look_different_and_there_are_only_so_many) {
  EXPECT_NE(board_pdf(kA4).value(), board_pdf({210, 297, 1}).value());
  EXPECT_FALSE(board_pdf({210, 297, 587}));
  EXPECT_FALSE(board_pdf({210, 297, -1}));
  EXPECT_FALSE(board_pdf({40, 40, 0}));
}

}  // namespace
}  // namespace roomcast::alignment
