// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/comparison_pictures.h"

#include <fstream>

#include <gmock/gmock.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kPng = std::string("\x89PNG\r\n\x1a\n") + "picture";

class ComparisonPicturesTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"real", "drawn"}) std::filesystem::create_directory(folder / name);
    plan.comparisons = {{.name = "c", .real = "real", .drawn = "drawn"}};
  }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  }
  TemporaryFolder folder;
  StudyPlan plan;
};

TEST_F(ComparisonPicturesTest, are_pairs_by_name_whatever_their_ending) {
  write("real/b.JPG", "\xff\xd8\xff photograph");
  write("real/a.png", kPng);
  write("real/alone.png", kPng);
  write("drawn/a.png", kPng);
  write("drawn/b.png", kPng);
  write("drawn/notes.txt", "no picture");
  const auto pictures = ComparisonPictures::find(plan, folder.path());
  ASSERT_TRUE(pictures.ok()) << pictures.error().message;
  EXPECT_THAT(pictures->pairs("c"), ElementsAre("a", "b"));
  EXPECT_TRUE(pictures->pairs("other").empty());
  EXPECT_EQ(pictures->read("c", 1, true)->content_type, "image/jpeg");
  EXPECT_EQ(pictures->read("c", 1, false)->bytes, kPng);
  EXPECT_EQ(pictures->read("c", 2, true).error().code, ErrorCode::kNotFound);
  EXPECT_EQ(pictures->read("x", 0, true).error().code, ErrorCode::kNotFound);
}

TEST_F(ComparisonPicturesTest, that_are_none_are_refused) {
  EXPECT_THAT(ComparisonPictures::find(plan, folder.path()).error().message,
              HasSubstr("has no pairs"));
  EXPECT_EQ(ComparisonPictures::find(plan, folder / "nowhere").error().code, ErrorCode::kNotFound);
  write("real/a.png", "<svg onload='alert(1)'>");
  write("drawn/a.png", kPng);
  const auto pictures = ComparisonPictures::find(plan, folder.path());
  ASSERT_TRUE(pictures.ok());
  EXPECT_EQ(pictures->read("c", 0, true).error().code, ErrorCode::kMalformed);
}

}  // namespace
}  // namespace roomcast::study
