// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/bytes/byte_source.h"

#include <array>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::recording {
namespace {

TEST(ByteSource, a_file_and_memory_give_the_same_bytes) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a", std::ios::binary) << "0123456789";
  const auto file = open_file(folder / "a");
  ASSERT_TRUE(file.ok());
  const auto memory = bytes_in_memory({'0', '1', '2', '3', '4', '5', '6', '7', '8', '9'});
  for (const ByteSource* source : {file->get(), memory.get()}) {
    EXPECT_EQ(source->size(), 10U);
    std::array<std::uint8_t, 3> three{};
    ASSERT_TRUE(source->read(7, three).ok());
    EXPECT_EQ(three, (std::array<std::uint8_t, 3>{'7', '8', '9'}));
    EXPECT_FALSE(source->read(8, three).ok());
    EXPECT_FALSE(source->read(std::numeric_limits<std::uint64_t>::max(), three).ok());
  }
}

TEST(ByteSource, what_is_no_file_is_not_found) {
  const TemporaryFolder folder;
  EXPECT_EQ(open_file(folder / "absent").error().code, ErrorCode::kNotFound);
  EXPECT_EQ(open_file(folder.path()).error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::recording
