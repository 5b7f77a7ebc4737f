// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/private_folder.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::io {
namespace {

namespace fs = std::filesystem;

constexpr fs::perms kOwnerOnly = fs::perms::owner_all;

fs::perms perms_of(const fs::path& path) {
  return fs::status(path).permissions();
}

TEST(PrivateFolder, is_created_for_its_owner_only) {
  const TemporaryFolder folder;
  const auto made = make_private_folder(folder / "a" / "b", {});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_FALSE(*made);
  EXPECT_EQ(perms_of(folder / "a" / "b"), kOwnerOnly);
}

TEST(PrivateFolder, that_others_could_enter_is_closed_once) {
  const TemporaryFolder folder;
  fs::permissions(folder.path(), kOwnerOnly | fs::perms::others_read | fs::perms::group_exec);
  EXPECT_TRUE(*make_private_folder(folder.path(), {}));
  EXPECT_EQ(perms_of(folder.path()), kOwnerOnly);
  EXPECT_FALSE(*make_private_folder(folder.path(), {}));
}

TEST(PrivateFolder, with_files_of_others_is_left_alone_until_ours_are_there) {
  const TemporaryFolder folder;
  fs::permissions(folder.path(), kOwnerOnly | fs::perms::others_read);
  std::ofstream(folder / "passwd") << "of others";
  EXPECT_FALSE(*make_private_folder(folder.path(), {"hub.sqlite", ".mcap"}));
  EXPECT_NE(perms_of(folder.path()), kOwnerOnly);
  std::ofstream(folder / "lab.mcap") << "a room";
  EXPECT_TRUE(*make_private_folder(folder.path(), {"hub.sqlite", ".mcap"}));
  EXPECT_EQ(perms_of(folder.path()), kOwnerOnly);
}

TEST(PrivateFolder, that_everybody_may_write_in_is_left_alone) {
  const TemporaryFolder folder;
  const fs::perms open = fs::perms::all | fs::perms::sticky_bit;
  fs::permissions(folder.path(), open);
  EXPECT_FALSE(*make_private_folder(folder.path(), {}));
  EXPECT_EQ(perms_of(folder.path()), open);
}

TEST(PrivateFolder, that_is_a_file_or_below_one_cannot_be_created) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "not a folder";
  for (const auto& path : {folder / "file", folder / "file" / "below"}) {
    const auto made = make_private_folder(path, {});
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, ErrorCode::kUnavailable);
  }
}

}  // namespace
}  // namespace roomcast::io
