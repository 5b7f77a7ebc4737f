// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/hub_secret.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub {
namespace {

namespace fs = std::filesystem;

TEST(HubSecret, is_created_once_and_read_again) {
  const TemporaryFolder folder;
  const auto made = find_hub_secret(folder.path() / "secret");
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(*find_hub_secret(folder.path() / "secret"), *made);
  EXPECT_NE(make_hub_secret(), *made);
}

TEST(HubSecret, is_readable_by_its_owner_only) {
  const TemporaryFolder folder;
  ASSERT_TRUE(find_hub_secret(folder.path() / "secret").ok());
  EXPECT_EQ(fs::status(folder.path() / "secret").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST(HubSecret, is_refused_if_others_may_read_it) {
  const TemporaryFolder folder;
  ASSERT_TRUE(find_hub_secret(folder.path() / "secret").ok());
  fs::permissions(folder.path() / "secret", fs::perms::group_read, fs::perm_options::add);
  const auto found = find_hub_secret(folder.path() / "secret");
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().message.find("chmod 600"), std::string::npos);
}

TEST(HubSecret, is_checked_without_being_created) {
  const TemporaryFolder folder;
  EXPECT_TRUE(check_hub_secret(folder / "secret").ok());
  EXPECT_FALSE(fs::exists(folder / "secret"));
  ASSERT_TRUE(find_hub_secret(folder / "secret").ok());
  EXPECT_TRUE(check_hub_secret(folder / "secret").ok());
  fs::permissions(folder / "secret", fs::perms::group_read, fs::perm_options::add);
  EXPECT_EQ(check_hub_secret(folder / "secret").error().code, ErrorCode::kInvalidArgument);
}

TEST(HubSecret, refuses_a_file_of_another_kind) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "secret") << "password";
  fs::permissions(folder.path() / "secret", fs::perms::owner_read);
  EXPECT_EQ(find_hub_secret(folder.path() / "secret").error().code, ErrorCode::kMalformed);
}

TEST(HubSecret, of_zeros_is_refused) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "secret") << std::string(std::tuple_size_v<HubSecret>, '\0');
  fs::permissions(folder.path() / "secret", fs::perms::owner_read);
  EXPECT_EQ(find_hub_secret(folder.path() / "secret").error().code, ErrorCode::kMalformed);
}

TEST(HubSecret, is_not_read_through_a_symbolic_link) {
  const TemporaryFolder folder;
  ASSERT_TRUE(find_hub_secret(folder.path() / "secret").ok());
  fs::create_symlink(folder.path() / "secret", folder.path() / "link");
  EXPECT_FALSE(find_hub_secret(folder.path() / "link").ok());
}

TEST(HubSecret, reports_a_folder_that_is_not_writable) {
  EXPECT_EQ(find_hub_secret("/nonexistent/folder/secret").error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::hub
