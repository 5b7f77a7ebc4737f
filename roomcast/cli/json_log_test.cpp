// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/json_log.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::cli {
namespace {

TEST(JsonLog, a_line_is_one_object_whatever_is_said) {
  const std::string line =
      json_log_line("hub", LogLevel::kWarning, "a \"name\"\nand \xff", 1'767'323'045'678);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const auto json = nlohmann::json::parse(line);
  EXPECT_EQ(json["time"], "2026-01-02T03:04:05.678Z");
  EXPECT_EQ(json["level"], "warning");
  EXPECT_EQ(json["program"], "hub");
}

}  // namespace
}  // namespace roomcast::cli
