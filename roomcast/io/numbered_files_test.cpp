// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/numbered_files.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::io {
namespace {

TEST(PictureFiles, are_numbered_and_never_written_over) {
  const TemporaryFolder folder;
  const auto first = next_free_path(folder.path() / "new", "roomcast-lab", ".png");
  ASSERT_TRUE(first.ok());
  EXPECT_EQ(first->filename(), "roomcast-lab-0001.png");
  std::ofstream(*first) << "x";
  EXPECT_EQ(next_free_path(folder.path() / "new", "roomcast-lab", ".png")->filename(),
            "roomcast-lab-0002.png");
}

TEST(PictureFiles, a_rooms_name_cannot_leave_the_folder) {
  EXPECT_EQ(file_stem("../etc/päss wd"), "roomcast----etc-p--ss-wd");
  EXPECT_EQ(file_stem(""), "roomcast");
}

TEST(PictureFiles, a_folder_that_cannot_be_made_is_named) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "x";
  const auto path = next_free_path(folder.path() / "file" / "sub", "a", ".png");
  ASSERT_FALSE(path.ok());
  EXPECT_NE(path.error().message.find("file/sub"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::io
