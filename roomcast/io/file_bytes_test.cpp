// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/file_bytes.h"

#include <csignal>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "roomcast/recording/dataset/recording_fixture.h"

namespace roomcast::io {
namespace {

TEST(FileBytes, reads_back_its_own_output) {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> written = {1, 0, 255, 10};
  ASSERT_TRUE(write_file(folder / "a", written).ok());
  std::vector<std::uint8_t> read = {9, 9, 9, 9, 9, 9};
  ASSERT_TRUE(read_file(folder / "a", 4, read).ok());
  EXPECT_EQ(read, written);
}

TEST(FileBytes, writing_leaves_no_unfinished_file) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file(folder / "a", "text").ok());
  ASSERT_TRUE(write_file(folder / "a", "newer").ok());
  EXPECT_EQ(recording::text_of(folder / "a"), "newer");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(FileBytes, lines_are_added_at_the_end) {
  const TemporaryFolder folder;
  ASSERT_TRUE(append_line(folder / "a", "one").ok());
  ASSERT_TRUE(append_line(folder / "a", "two").ok());
  EXPECT_EQ(recording::text_of(folder / "a"), "one\ntwo\n");
}

TEST(FileBytes, reading_refuses_missing_and_large_files_and_folders) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> bytes;
  const Status missing = read_file(folder / "none", 10, bytes);
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, ErrorCode::kNotFound);
  EXPECT_EQ(missing.error().message, (folder / "none").string() + " is missing");
  EXPECT_EQ(read_file(folder.path(), 10, bytes).error().code, ErrorCode::kNotFound);
  recording::put_text(folder / "large", "12345678901");
  EXPECT_EQ(read_file(folder / "large", 10, bytes).error().code, ErrorCode::kTooLarge);
}

TEST(FileBytes, a_file_that_does_not_fit_leaves_nothing_behind) {
  const TemporaryFolder folder;
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{100, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  const Status status = write_file(folder / "a", std::string(1000, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("File too large"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(FileBytes, a_device_is_written_to_and_not_replaced) {
  const TemporaryFolder folder;
  const auto link = folder / "null";
  std::filesystem::create_symlink("/dev/null", link);
  EXPECT_TRUE(write_file(link, "text").ok());
  EXPECT_TRUE(std::filesystem::is_character_file(link));
  std::filesystem::remove(link);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(FileBytes, a_folder_is_not_replaced) {
  const TemporaryFolder folder;
  const Status status = write_file(folder.path(), "text");
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("directory"), std::string::npos) << status.error().message;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(FileBytes, writing_into_a_missing_folder_says_so) {
  const TemporaryFolder folder;
  const Status status = write_file(folder / "none/a", "text");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kUnavailable);
  EXPECT_NE(status.error().message.find("none/a"), std::string::npos);
  EXPECT_FALSE(append_line(folder / "none/a", "text").ok());
}

}  // namespace
}  // namespace roomcast::io
