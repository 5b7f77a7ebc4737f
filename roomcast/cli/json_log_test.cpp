// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/json_log.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::cli {
namespace {

TEST(JsonLog, every_line_is_one_object) {
  const std::string line =
      json_log_line("hub", LogLevel::kWarning, "a \"name\"\nand \xff", {}, 1'767'323'045'678);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const auto json = nlohmann::json::parse(line);
  EXPECT_EQ(json["time"], "2026-01-02T03:04:05.678Z");
  EXPECT_EQ(json["level"], "warning");
  EXPECT_EQ(json["program"], "hub");
}

TEST(JsonLog, fields_are_keys_and_replace_no_other_key) {
  const LogField fields[] = {{"room", "lab"}, {"token", ""}, {"level", "none"}};
  const auto json = nlohmann::json::parse(json_log_line("hub", LogLevel::kInfo, "", fields, 0));
  EXPECT_EQ(json["room"], "lab");
  EXPECT_FALSE(json.contains("token")) << "there is none";
  EXPECT_EQ(json["level"], "info") << "not to be replaced";
}

}  // namespace
}  // namespace roomcast::cli
