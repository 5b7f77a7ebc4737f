// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/log.h"

#include <string>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(LogSink, may_be_empty) {
  EXPECT_FALSE(LogSink());
}

TEST(LogSink, passes_on_the_line_and_its_subject) {
  std::string heard;
  const LogSink log = [&](LogLevel, std::string_view line, LogFields fields) {
    heard = line;
    for (const auto& [key, value] : fields) heard.append(" ").append(key).append("=").append(value);
  };
  ASSERT_TRUE(log);
  log(LogLevel::kInfo, "Ada joins", {{"room", "lab"}, {"role", "viewer"}});
  EXPECT_EQ(heard, "Ada joins room=lab role=viewer");
  log(LogLevel::kInfo, "nothing else");
  EXPECT_EQ(heard, "nothing else");
}

TEST(LogSink, a_sink_for_text_gets_the_line_alone) {
  std::string heard;
  const LogSink log = [&](LogLevel, std::string_view line) { heard = line; };
  log(LogLevel::kWarning, "a line", {{"room", "lab"}});
  EXPECT_EQ(heard, "a line");
}

}  // namespace
}  // namespace roomcast
