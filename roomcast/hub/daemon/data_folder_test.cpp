// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/data_folder.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub::daemon {
namespace {

TEST(DataFolder, is_the_named_folder) {
  EXPECT_EQ(data_folder("/srv/hub")->string(), "/srv/hub");
  EXPECT_TRUE(data_folder("") == default_data_folder());
}

TEST(DataFolder, is_created_with_its_parents) {
  const TemporaryFolder folder;
  ASSERT_TRUE(make_data_folder(folder / "a" / "b", {}).ok());
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a" / "b"));
}

TEST(DataFolder, that_others_could_read_is_closed_with_a_sentence) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_all | fs::perms::others_read);
  std::vector<std::string> said;
  const LogSink log = [&](LogLevel, std::string_view line) { said.emplace_back(line); };
  ASSERT_TRUE(make_data_folder(folder.path(), log).ok());
  EXPECT_EQ(fs::status(folder.path()).permissions(), fs::perms::owner_all);
  ASSERT_TRUE(make_data_folder(folder.path(), log).ok());
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("is closed to them now"), std::string::npos);
}

TEST(DataFolder, is_checked_without_being_created) {
  const TemporaryFolder folder;
  EXPECT_TRUE(check_folder(folder.path()).ok());
  EXPECT_TRUE(check_folder(folder / "a" / "b").ok());
  EXPECT_FALSE(std::filesystem::exists(folder / "a"));
}

TEST(DataFolder, rejects_a_file_and_a_path_below_a_file) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "not a folder";
  for (const auto& path : {folder / "file", folder / "file" / "below"}) {
    const auto checked = check_folder(path);
    ASSERT_FALSE(checked.ok());
    EXPECT_EQ(checked.error().code, ErrorCode::kUnavailable);
    EXPECT_NE(checked.error().message.find((folder / "file").string() + " is no folder"),
              std::string::npos)
        << checked.error().message;
    EXPECT_FALSE(make_data_folder(path, {}).ok());
  }
}

}  // namespace
}  // namespace roomcast::hub::daemon
