// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/text_file.h"

#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast {
namespace {

TEST(TextFile, is_read_up_to_its_limit) {
  const TemporaryFolder folder;
  std::ofstream(folder / "text") << "12345";
  EXPECT_EQ(*read_text_file(folder / "text", 5), "12345");
  EXPECT_EQ(read_text_file(folder / "text", 4).error().code, ErrorCode::kTooLarge);
}

TEST(TextFile, without_an_end_is_too_large) {
  EXPECT_EQ(read_text_file("/dev/zero", 1000).error().code, ErrorCode::kTooLarge);
}

TEST(TextFile, that_is_a_folder_or_absent_is_refused_with_a_sentence) {
  const TemporaryFolder folder;
  for (const auto& path : {folder.path(), folder / "absent"}) {
    const auto text = read_text_file(path, 10);
    ASSERT_FALSE(text.ok()) << path;
    EXPECT_EQ(text.error().code, ErrorCode::kNotFound);
    EXPECT_NE(text.error().message.find("cannot read " + path.string() + ": "), std::string::npos);
  }
}

TEST(TextFile, may_come_through_a_pipe) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], "token", 5), 5);
  ::close(ends[1]);
  EXPECT_EQ(*read_text_file("/proc/self/fd/" + std::to_string(ends[0]), 10), "token");
  ::close(ends[0]);
}

}  // namespace
}  // namespace roomcast
