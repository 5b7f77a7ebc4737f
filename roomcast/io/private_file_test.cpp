// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/private_file.h"

#include <csignal>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::io {
namespace {

TEST(PrivateFile, is_for_its_owner_only_whatever_the_umask) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(0);
  ASSERT_TRUE(write_private_file(folder / "a.token", "sesame\n").ok());
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat((folder / "a.token").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
  std::ifstream file(folder / "a.token");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "sesame\n");
}

TEST(PrivateFile, overwrites_nothing) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_private_file(folder / "a.token", "first").ok());
  const Status again = write_private_file(folder / "a.token", "second");
  ASSERT_FALSE(again.ok());
  EXPECT_NE(again.error().message.find("a.token: File exists"), std::string::npos);
}

TEST(PrivateFile, that_does_not_fit_leaves_nothing_behind) {
  const TemporaryFolder folder;
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{3, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  const Status status = write_private_file(folder / "a.token", "sesame\n");
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(status.ok());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace roomcast::io
