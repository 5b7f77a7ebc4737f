// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/mark_list.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/wire/control.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
namespace pb = wire::pb;

pb::Mark mark_of(std::uint64_t author, int points = 1) {
  pb::Mark mark;
  mark.set_kind(points == 1 ? pb::MARK_KIND_NOTE : pb::MARK_KIND_SKETCH);
  if (points == 1) mark.set_text("a note");
  for (int i = 0; i < 3 * points; ++i) mark.add_points(1.25f);
  mark.set_author_tag(author);
  return mark;
}

TEST(MarkList, marks_have_ids_that_stay_free_after_they_are_remembered) {
  MarkList list;
  EXPECT_EQ(list.add(mark_of(1))->id(), 1u);
  EXPECT_EQ(list.add(mark_of(1))->id(), 2u);
  pb::Mark kept = mark_of(1);
  kept.set_id(40);
  MarkList later;
  later.remember({kept});
  EXPECT_EQ(later.size(), 1u);
  EXPECT_EQ(later.messages()[0].marks().marks(0).id(), 40u);
  EXPECT_EQ(later.add(mark_of(1))->id(), 41u);
}

TEST(MarkList, only_the_author_and_admins_remove_a_mark) {
  MarkList list;
  const auto add = [&](std::uint64_t author) { return list.add(mark_of(author))->id(); };
  const std::vector<std::uint32_t> ids = {add(1), add(2), add(0), 99};
  EXPECT_THAT(list.remove(ids, {.author_tag = 3}), IsEmpty());
  EXPECT_THAT(list.remove(ids, {}), IsEmpty()) << "without a key nobody's marks are one's own";
  EXPECT_THAT(list.remove(ids, {.author_tag = 2}), ElementsAre(2u));
  EXPECT_THAT(list.remove(ids, {.may_remove_all = true}), ElementsAre(1u, 3u));
  EXPECT_EQ(list.size(), 0u);
}

TEST(MarkList, one_author_leaves_room_for_others) {
  MarkList list;
  for (int i = 0; i < wire::kMaxMarksOfAuthor; ++i) ASSERT_TRUE(list.add(mark_of(1)));
  const auto refused = list.add(mark_of(1));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("you have left 100 marks"));
  EXPECT_TRUE(list.add(mark_of(2)));
  ASSERT_EQ(list.remove(std::vector<std::uint32_t>{1}, {.author_tag = 1}).size(), 1u);
  EXPECT_TRUE(list.add(mark_of(1)));
}

TEST(MarkList, a_full_room_takes_no_more_and_keeps_what_it_has) {
  MarkList list;
  for (int i = 0; i < wire::kMaxMarks; ++i) ASSERT_TRUE(list.add(mark_of(1 + i / 50)));
  const auto refused = list.add(mark_of(1000));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("500 marks"));
  EXPECT_EQ(list.size(), std::size_t{wire::kMaxMarks});
}

TEST(MarkList, points_of_all_sketches_are_limited) {
  MarkList list;
  int points = 0;
  for (; points + wire::kMaxMarkPoints <= wire::kMaxPointsOfMarks; points += wire::kMaxMarkPoints) {
    ASSERT_TRUE(list.add(mark_of(1 + points / 20'000, wire::kMaxMarkPoints)));
  }
  EXPECT_FALSE(list.add(mark_of(9, wire::kMaxMarkPoints)));
  EXPECT_TRUE(list.add(mark_of(9)));
  ASSERT_EQ(list.remove(std::vector<std::uint32_t>{1}, {.may_remove_all = true}).size(), 1u);
  EXPECT_TRUE(list.add(mark_of(9, wire::kMaxMarkPoints)));
}

TEST(MarkList, all_marks_fit_into_messages_that_a_viewer_takes) {
  MarkList list;
  EXPECT_THAT(list.messages(), IsEmpty());
  for (int i = 0; i < 97; ++i) ASSERT_TRUE(list.add(mark_of(1, wire::kMaxMarkPoints)));
  const auto messages = list.messages();
  EXPECT_GT(messages.size(), 1u);
  EXPECT_LT(messages.size(), wire::kMaxQueuedControlMessages / 4);
  int marks = 0;
  for (const pb::Control& message : messages) {
    std::vector<std::uint8_t> bytes;
    wire::encode_control(message, bytes);
    EXPECT_TRUE(wire::decode_control(bytes, wire::Sender::kHub));
    EXPECT_EQ(message.marks().all(), marks == 0);
    marks += message.marks().marks_size();
  }
  EXPECT_EQ(marks, 97);
}

}  // namespace
}  // namespace roomcast::hub
