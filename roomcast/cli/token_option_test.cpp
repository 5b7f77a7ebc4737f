// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/token_option.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::cli {
namespace {

TEST(TokenOption, comes_from_a_file_or_the_environment) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "token";
  std::ofstream(file) << "from.a.file\n";
  EXPECT_EQ(find_credential({.file = file})->token, "from.a.file");
  std::filesystem::remove(file);
  EXPECT_EQ(find_credential({.file = file}).error().code, ErrorCode::kNotFound);
  ::setenv("ROOMCAST_TOKEN", "from.the.environment", 1);
  EXPECT_EQ(find_credential({})->token, "from.the.environment");
  ::unsetenv("ROOMCAST_TOKEN");
  EXPECT_EQ(find_credential({})->token, "");
}

TEST(TokenOption, both_at_once_are_refused) {
  EXPECT_EQ(find_credential({.token = "a", .file = "b"}).error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace roomcast::cli
