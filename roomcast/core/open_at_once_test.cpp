// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/open_at_once.h"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast {
namespace {

TEST(OpenAtOnce, a_pipe_that_nobody_writes_to_is_an_empty_file) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const OwnedFile file = open_file_at_once(folder / "pipe", "r");
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(std::fgetc(file.get()), EOF);
}

TEST(OpenAtOnce, a_pipe_that_nobody_reads_is_an_error) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(open_file_at_once(folder / "pipe", "w"), nullptr);
  EXPECT_EQ(errno, ENXIO);
}

TEST(OpenAtOnce, what_was_opened_waits_for_its_data_as_usual) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const int reading = open_at_once("/proc/self/fd/" + std::to_string(ends[0]), O_RDONLY);
  EXPECT_EQ(::fcntl(reading, F_GETFL) & O_NONBLOCK, 0);
  for (const int descriptor : {reading, ends[0], ends[1]}) ::close(descriptor);
}

TEST(OpenAtOnce, files_are_replaced_or_added_to) {
  const TemporaryFolder folder;
  for (const char* mode : {"w", "w", "a"})
    std::fputs("12", open_file_at_once(folder / "a", mode).get());
  EXPECT_EQ(std::filesystem::file_size(folder / "a"), 4U);
  EXPECT_EQ(open_file_at_once(folder / "none", "r"), nullptr);
}

}  // namespace
}  // namespace roomcast
