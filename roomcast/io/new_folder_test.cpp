// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/new_folder.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::io {
namespace {

TEST(NewFolder, is_made_with_what_is_missing_above_it) {
  const TemporaryFolder place;
  const auto wanted = place / "a/b";
  EXPECT_TRUE(make_new_folder(wanted).ok());
  EXPECT_TRUE(std::filesystem::is_directory(wanted));
  EXPECT_TRUE(make_folder(wanted).ok());
  const Status again = make_new_folder(wanted);
  EXPECT_EQ(again.error().code, ErrorCode::kUnavailable);
  EXPECT_EQ(again.error().message,
            "there is " + wanted.string() + " already; choose another folder");
}

TEST(NewFolder, cannot_be_below_a_file) {
  const TemporaryFolder place;
  std::ofstream(place / "file") << "taken";
  const Status made = make_folder(place / "file/below");
  EXPECT_EQ(made.error().code, ErrorCode::kUnavailable);
  EXPECT_TRUE(made.error().message.starts_with("cannot make the folder " +
                                               (place / "file/below").string()));
}

}  // namespace
}  // namespace roomcast::io
