// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/child_program.h"

#include <array>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace roomcast {
namespace {

std::string all_of(int pipe) {
  std::string text;
  std::array<char, 64> part{};
  for (ssize_t count = 0; (count = ::read(pipe, part.data(), part.size())) > 0;)
    text.append(part.data(), static_cast<std::size_t>(count));
  return text;
}

TEST(ChildProgram, is_found_on_the_path_and_writes_to_the_pipe) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
  const auto pid = start_program({"echo", "two", "words"}, {.output = ends[1]});
  ::close(ends[1]);
  ASSERT_TRUE(pid.ok());
  EXPECT_EQ(all_of(ends[0]), "two words\n");
  ::close(ends[0]);
  EXPECT_EQ(wait_for_program(*pid), 0);
}

TEST(ChildProgram, has_no_input_where_none_is_given) {
  const auto pid = start_program({"sh", "-c", "read line"}, {});
  ASSERT_TRUE(pid.ok());
  const int status = wait_for_program(*pid);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
}

TEST(ChildProgram, that_is_missing_does_not_start) {
  const auto pid = start_program({"/no/such/program"}, {});
  ASSERT_FALSE(pid.ok());
  EXPECT_EQ(pid.error().code, ErrorCode::kUnavailable);
  EXPECT_EQ(pid.error().message, "No such file or directory");
}

}  // namespace
}  // namespace roomcast
