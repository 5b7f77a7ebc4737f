// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/print.h"

#include <memory>

#include <gtest/gtest.h>
#include <unistd.h>

namespace roomcast::cli {
namespace {

TEST(Print, plain_text_and_names_of_all_languages_stay) {
  for (const char* text : {"", "two\nlines\tand a tab", "Zoë, 居間, مرحبا, 🎥"})
    EXPECT_EQ(printable(text), text);
}

TEST(Print, what_steers_a_terminal_is_spelled_out) {
  EXPECT_EQ(printable("\x1b[31mred"), "\\u001B[31mred");
  EXPECT_EQ(printable("back\rover\b\x07\x7f"), "back\\u000Dover\\u0008\\u0007\\u007F");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "\\u009B31m");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\u0000");
}

TEST(Print, what_turns_or_hides_text_is_spelled_out) {
  EXPECT_EQ(printable("a\u202Eb"), "a\\u202Eb");
  EXPECT_EQ(printable("\u2066\u200F\u061C"), "\\u2066\\u200F\\u061C");
  EXPECT_EQ(printable("lab\u200B\uFEFF"), "lab\\u200B\\uFEFF");
}

TEST(Print, a_line_stays_one_line) {
  EXPECT_EQ(one_line("a\nb\tc"), "a\\u000Ab\\u0009c");
  EXPECT_EQ(one_line("\x1b[31mred"), "\\u001B[31mred");
}

TEST(Print, bytes_that_are_not_utf8_are_spelled_out) {
  EXPECT_EQ(printable("\x9B"
                      "31m"),
            "\\x9B31m");
  EXPECT_EQ(printable("cut \xE2\x80"), "cut \\xE2\\x80");
  EXPECT_EQ(printable("\xC0\x80\xFF"), "\\xC0\\x80\\xFF");
}

TEST(Print, a_stream_that_takes_nothing_is_a_failure_and_no_end) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> full(std::fopen("/dev/full", "w"),
                                                             &std::fclose);
  ASSERT_NE(full, nullptr);
  std::setvbuf(full.get(), nullptr, _IONBF, 0);
  EXPECT_FALSE(write_raw(full.get(), "word"));
}

}  // namespace
}  // namespace roomcast::cli
