// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/room/room_mark.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::client {
namespace {

constexpr std::uint64_t kOwnTag = 77;

wire::pb::Mark left_note(std::uint32_t id, std::uint64_t tag, const std::string& text = "leaks") {
  wire::pb::Mark mark;
  mark.set_id(id);
  mark.set_kind(wire::pb::MARK_KIND_NOTE);
  for (const float number : {1.0F, 2.0F, 3.0F}) mark.add_points(number);
  mark.set_text(text);
  mark.set_author("Ada");
  mark.set_color_rgb(0x102030);
  mark.set_author_tag(tag);
  return mark;
}

TEST(RoomMarks, are_added_replaced_and_removed_in_the_order_of_their_ids) {
  RoomMarks marks;
  marks.join(kOwnTag);
  wire::pb::Marks news;
  *news.add_marks() = left_note(8, 1);
  *news.add_marks() = left_note(3, kOwnTag);
  marks.take(news);
  ASSERT_EQ(marks.all()->size(), 2u);
  const RoomMark& first = marks.all()->front();
  EXPECT_EQ(first.id, 3u);
  EXPECT_TRUE(first.own);
  EXPECT_EQ(first.points_m, std::vector{Eigen::Vector3f(1, 2, 3)});
  EXPECT_EQ(first.color, (Rgb8{0x10, 0x20, 0x30}));
  EXPECT_FALSE(marks.all()->back().own);

  news.Clear();
  news.add_removed(3);
  *news.add_marks() = left_note(8, 1, "dry again");
  marks.take(news);
  ASSERT_EQ(marks.all()->size(), 1u);
  EXPECT_EQ(marks.all()->front().text, "dry again");
}

TEST(RoomMarks, a_complete_message_and_joining_anew_replace_what_was_known) {
  RoomMarks marks;
  wire::pb::Marks news;
  *news.add_marks() = left_note(1, 0);
  marks.take(news);
  EXPECT_FALSE(marks.all()->front().own) << "nobody has the tag 0";
  news.Clear();
  news.set_all(true);
  *news.add_marks() = left_note(2, 0);
  marks.take(news);
  ASSERT_EQ(marks.all()->size(), 1u);
  EXPECT_EQ(marks.all()->front().id, 2u);
  marks.join(0);
  EXPECT_TRUE(marks.all()->empty());
}

TEST(RoomMarks, a_refusal_changes_nothing_and_kinds_of_later_versions_are_left_out) {
  RoomMarks marks;
  wire::pb::Marks news;
  auto later = left_note(1, 0);
  later.set_kind(static_cast<wire::pb::MarkKind>(9));
  *news.add_marks() = later;
  marks.take(news);
  EXPECT_TRUE(marks.all()->empty());
  const auto before = marks.all();
  news.Clear();
  news.set_refusal("too many");
  marks.take(news);
  EXPECT_EQ(marks.all(), before);
}

TEST(RoomMarks, what_no_hub_takes_is_refused_with_a_sentence) {
  RoomMark mark;
  mark.points_m = {{0, 1, 0}};
  EXPECT_EQ(message_from_mark(mark).error().message, "a note and a place need words");
  mark.text = "here";
  ASSERT_TRUE(message_from_mark(mark).ok());
  EXPECT_EQ(message_from_mark(mark)->points_size(), 3);
  mark.points_m[0].x() = std::nanf("");
  EXPECT_EQ(message_from_mark(mark).error().code, ErrorCode::kMalformed);
}

}  // namespace
}  // namespace roomcast::client
