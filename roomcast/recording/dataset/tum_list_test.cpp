// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/dataset/tum_list.h"

#include <gtest/gtest.h>

#include "roomcast/recording/dataset/recording_fixture.h"

namespace roomcast::recording {
namespace {

TEST(ParseSeconds, keeps_every_digit) {
  nanoseconds time{};
  ASSERT_TRUE(parse_seconds("1305031102.175304", time));
  EXPECT_EQ(time.count(), 1305031102175304000);
  ASSERT_TRUE(parse_seconds("0.000000001", time));
  EXPECT_EQ(time.count(), 1);
  ASSERT_TRUE(parse_seconds("-1.5", time));
  EXPECT_EQ(time.count(), -1500000000);
  ASSERT_TRUE(parse_seconds("7", time));
  EXPECT_EQ(time.count(), 7000000000);
  ASSERT_TRUE(parse_seconds("1.1234567899", time));  // a tenth digit is cut off
  EXPECT_EQ(time.count(), 1123456789);
}

TEST(TumSeconds, are_read_again_as_they_were) {
  for (const std::int64_t ns : {0L, 1L, -1L, -1500000000L, 1305031102175304001L}) {
    nanoseconds time{};
    ASSERT_TRUE(parse_seconds(tum_seconds(nanoseconds(ns)), time)) << ns;
    EXPECT_EQ(time.count(), ns);
  }
}

TEST(ParseSeconds, refuses_invalid_times) {
  nanoseconds time{};
  for (const char* text :
       {"", "-", ".", ".5", "1e5", "nan", "1.2.3", "0x10", "1 2", "99999999999"}) {
    EXPECT_FALSE(parse_seconds(text, time)) << text;
  }
}

class TumList : public testing::Test {
 protected:
  Result<std::vector<ListedFile>> read(const std::string& text) {
    put_text(folder_ / "depth.txt", text);
    return read_tum_list(folder_ / "depth.txt");
  }
  void expect_refused(const std::string& text, const std::string& part_of_message) {
    const auto files = read(text);
    ASSERT_FALSE(files.ok()) << text;
    EXPECT_EQ(files.error().code, ErrorCode::kMalformed);
    EXPECT_NE(files.error().message.find(part_of_message), std::string::npos)
        << files.error().message;
    EXPECT_NE(files.error().message.find("depth.txt line 2"), std::string::npos)
        << files.error().message;
  }
  TemporaryFolder folder_;
};

TEST_F(TumList, reads_lines_and_skips_comments) {
  const auto files =
      read("# timestamp path\r\n\n1.5 depth/a.png\r\n  2.5\tdepth/b.png extra\n3.5 c");
  ASSERT_TRUE(files.ok());
  ASSERT_EQ(files->size(), 3U);
  EXPECT_EQ((*files)[0].timestamp, nanoseconds(1500000000));
  EXPECT_EQ((*files)[0].file, "depth/a.png");
  EXPECT_EQ((*files)[1].file, "depth/b.png");
  EXPECT_EQ((*files)[2].file, "c");
}

TEST_F(TumList, names_file_and_line_of_an_error) {
  expect_refused("1.5 a\n2.5\n", "expected a timestamp and a file");
  expect_refused("1.5 a\nx b\n", "timestamp");
  expect_refused("1.5 a\n1.5 b\n", "must grow");
  expect_refused("1.5 a\n2.5 ../../secret\n", "inside");
  expect_refused("1.5 a\n2.5 /etc/passwd\n", "inside");
}

TEST_F(TumList, associations_are_read_in_either_order) {
  const std::vector<ListedFile> depth = {{nanoseconds(1), "d/0"}, {nanoseconds(2), "d/1"}};
  put_text(folder_ / "a.txt", "1 d/0 1.1 c/0\n2.1 c/1 2 d/1\n");
  auto color_of_depth = read_associations(folder_ / "a.txt", depth);
  ASSERT_TRUE(color_of_depth.ok());
  EXPECT_EQ((*color_of_depth)["d/0"], "c/0");
  EXPECT_EQ((*color_of_depth)["d/1"], "c/1");
  put_text(folder_ / "a.txt", "1 x 1 y\n");
  EXPECT_FALSE(read_associations(folder_ / "a.txt", depth).ok());
}

std::vector<ListedFile> at_ms(const std::vector<int>& times_ms) {
  std::vector<ListedFile> files;
  for (const int ms : times_ms) files.push_back({nanoseconds(ms * 1000000LL), std::to_string(ms)});
  return files;
}

TEST(AssociateByTime, takes_the_nearest_within_the_tolerance) {
  const auto depth = at_ms({0, 33, 66, 99, 150});
  const auto color = at_ms({4, 30, 90, 100});
  EXPECT_EQ(associate_by_time(depth, color, nanoseconds(16500000)),
            (std::vector<std::string>{"4", "30", "", "100", ""}));
  EXPECT_EQ(associate_by_time(depth, {}, nanoseconds(16500000)), std::vector<std::string>(5));
}

}  // namespace
}  // namespace roomcast::recording
