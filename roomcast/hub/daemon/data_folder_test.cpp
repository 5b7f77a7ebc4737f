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
  ASSERT_TRUE(make_data_folder(folder / "a" / "b").ok());
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a" / "b"));
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
    EXPECT_FALSE(make_data_folder(path).ok());
  }
}

}  // namespace
}  // namespace roomcast::hub::daemon
