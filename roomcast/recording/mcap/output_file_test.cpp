// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mcap/output_file.h"

#include <csignal>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::recording::mcap {
namespace {

TEST(OutputFile, overwrites_nothing) {
  const TemporaryFolder folder;
  ASSERT_TRUE(OutputFile::create(folder / "a").ok());
  const auto again = OutputFile::create(folder / "a");
  ASSERT_FALSE(again.ok());
  EXPECT_NE(again.error().message.find("nothing is overwritten"), std::string::npos);
}

TEST(OutputFile, is_for_its_owner_only) {
  const TemporaryFolder folder;
  ASSERT_TRUE(OutputFile::create(folder / "out").ok());
  using std::filesystem::perms;
  EXPECT_EQ(std::filesystem::status(folder / "out").permissions(),
            perms::owner_read | perms::owner_write);
}

TEST(OutputFile, says_where_it_cannot_be_made) {
  const auto file = OutputFile::create("/no/such/folder/a.mcap");
  ASSERT_FALSE(file.ok());
  EXPECT_EQ(file.error().code, ErrorCode::kUnavailable);
  EXPECT_NE(file.error().message.find("/no/such/folder/a.mcap"), std::string::npos);
}

/// Simulates a full disk by a limit on the file size.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST(OutputFile, a_piece_that_does_not_fit_leaves_no_trace) {
  const TemporaryFolder folder;
  auto file = OutputFile::create(folder / "a");
  ASSERT_TRUE(file.ok());
  const std::vector<std::uint8_t> piece(3000, 1);
  const SmallDisk disk(5000);
  EXPECT_TRUE(file->append(piece).ok());
  const auto status = file->append(piece);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kUnavailable);
  EXPECT_EQ(std::filesystem::file_size(folder / "a"), 3000u);
  EXPECT_TRUE(file->append(std::span(piece).first(1000)).ok());  // a smaller one still fits
  EXPECT_EQ(std::filesystem::file_size(folder / "a"), 4000u);
}

}  // namespace
}  // namespace roomcast::recording::mcap
