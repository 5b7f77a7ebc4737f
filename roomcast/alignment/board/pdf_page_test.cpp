// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/board/pdf_page.h"

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

const std::string kDrawing = "0 0 72 36 re f\n";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(PdfPage, an_inch_is_72_points) {
  EXPECT_TRUE(contains(pdf_page(25.4, 50.8, kDrawing), "/MediaBox [0 0 72.0000 144.0000]"));
}

TEST(PdfPage, holds_the_drawing_with_its_length) {
  const std::string pdf = pdf_page(100, 100, kDrawing);
  EXPECT_TRUE(contains(pdf, "<< /Length 15 >>\nstream\n" + kDrawing + "endstream"));
  EXPECT_TRUE(contains(pdf_page(100, 100, ""), "<< /Length 0 >>\nstream\nendstream"));
}

TEST(PdfPage, says_where_each_object_and_the_table_begin) {
  const std::string pdf = pdf_page(100, 100, kDrawing);
  const std::size_t table = std::stoul(pdf.substr(pdf.find("startxref\n") + 10));
  const std::string head = "xref\n0 6\n0000000000 65535 f \n";  // entries are 20 bytes
  ASSERT_EQ(pdf.substr(table, head.size()), head);
  for (std::size_t object = 1; object <= 5; ++object) {
    const std::size_t at = std::stoul(pdf.substr(table + head.size() + 20 * (object - 1), 10));
    EXPECT_EQ(pdf.substr(at, 8), std::to_string(object) + " 0 obj\n") << object;
  }
  EXPECT_TRUE(contains(pdf, "trailer\n<< /Size 6 /Root 1 0 R >>"));
}

TEST(PdfPage, has_helvetica_as_f1) {
  const std::string pdf = pdf_page(100, 100, kDrawing);
  EXPECT_TRUE(contains(pdf, "/F1 5 0 R"));
  EXPECT_TRUE(contains(pdf, "5 0 obj\n<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"));
}

}  // namespace
}  // namespace roomcast::alignment
