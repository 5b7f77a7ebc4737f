// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/stderr_log.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::cli {
namespace {

using testing::ElementsAre;

class CountingLog : public testing::Test {
 protected:
  bool has_room = true;
  std::vector<std::string> written;
  LogSink log = counting_log(
      [](LogLevel, std::string_view message, LogFields) { return std::string(message); },
      [this](std::string_view line) {
        if (has_room) written.emplace_back(line);
        return has_room;
      });
};

TEST_F(CountingLog, lines_that_are_lost_are_counted_and_told_with_the_next_one) {
  log(LogLevel::kInfo, "one");
  has_room = false;
  log(LogLevel::kInfo, "two");
  log(LogLevel::kInfo, "three");
  has_room = true;
  log(LogLevel::kInfo, "four");
  log(LogLevel::kInfo, "five");
  EXPECT_THAT(written,
              ElementsAre("one", "2 lines before this one could not be written", "four", "five"));
}

TEST_F(CountingLog, a_line_without_text_is_none) {
  log(LogLevel::kInfo, "");
  EXPECT_TRUE(written.empty());
}

}  // namespace
}  // namespace roomcast::cli
