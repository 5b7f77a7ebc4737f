// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/mark_check.h"

#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/wire/control.h"
#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

using testing::HasSubstr;

pb::Mark mark(pb::MarkKind kind, int points, const std::string& text = "") {
  pb::Mark mark;
  mark.set_kind(kind);
  for (int i = 0; i < 3 * points; ++i) mark.add_points(static_cast<float>(i) / 1000);
  mark.set_text(text);
  return mark;
}

TEST(MarkCheck, every_kind_has_its_number_of_points_and_its_words) {
  EXPECT_TRUE(check_mark(mark(pb::MARK_KIND_NOTE, 1, "mind the step")));
  EXPECT_TRUE(check_mark(mark(pb::MARK_KIND_SKETCH, 2)));
  EXPECT_TRUE(check_mark(mark(pb::MARK_KIND_SKETCH, kMaxMarkPoints)));
  EXPECT_TRUE(check_mark(mark(pb::MARK_KIND_DISTANCE, 2)));
  EXPECT_TRUE(check_mark(mark(pb::MARK_KIND_PLACE, 2, "the desk")));
  for (const pb::Mark& wrong :
       {mark(pb::MARK_KIND_NOTE, 2, "two"), mark(pb::MARK_KIND_NOTE, 1),
        mark(pb::MARK_KIND_SKETCH, 1), mark(pb::MARK_KIND_SKETCH, 2, "words"),
        mark(pb::MARK_KIND_DISTANCE, 3), mark(pb::MARK_KIND_PLACE, 1, "the desk"),
        mark(pb::MARK_KIND_UNSPECIFIED, 1, "none"),
        mark(static_cast<pb::MarkKind>(99), 1, "new")}) {
    EXPECT_FALSE(check_mark(wrong)) << wrong.ShortDebugString();
  }
  pb::Mark cut = mark(pb::MARK_KIND_SKETCH, 2);
  cut.mutable_points()->RemoveLast();
  EXPECT_FALSE(check_mark(cut));
}

TEST(MarkCheck, a_mark_of_too_many_points_is_refused_with_a_remedy) {
  const auto status = check_mark(mark(pb::MARK_KIND_SKETCH, 1'000'000));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kTooLarge);
  EXPECT_THAT(status.error().message, HasSubstr("1000000 points, and a mark may have 512"));
}

TEST(MarkCheck, points_that_are_no_place_in_a_room_are_refused) {
  for (const float metres : {std::numeric_limits<float>::quiet_NaN(),
                             std::numeric_limits<float>::infinity(), 10'001.f}) {
    pb::Mark lost = mark(pb::MARK_KIND_NOTE, 1, "here");
    lost.set_points(1, metres);
    EXPECT_FALSE(check_mark(lost)) << metres;
  }
}

TEST(MarkCheck, words_are_short_and_plain_text) {
  EXPECT_TRUE(check_mark(mark(pb::MARK_KIND_NOTE, 1, std::string(kMaxMarkTextBytes, 'a'))));
  EXPECT_FALSE(check_mark(mark(pb::MARK_KIND_NOTE, 1, std::string(kMaxMarkTextBytes + 1, 'a'))));
  EXPECT_FALSE(check_mark(mark(pb::MARK_KIND_PLACE, 2, std::string(kMaxNameBytes + 1, 'a'))));
  EXPECT_FALSE(check_mark(mark(pb::MARK_KIND_NOTE, 1, "two\nlines")));
  EXPECT_FALSE(check_mark(mark(pb::MARK_KIND_NOTE, 1, "\xff")));
}

TEST(MarkCheck, applies_to_all_marks_of_a_message) {
  pb::Control control;
  *control.mutable_marks()->add_marks() = mark(pb::MARK_KIND_NOTE, 1, "good");
  std::vector<std::uint8_t> bytes;
  encode_control(control, bytes);
  EXPECT_TRUE(decode_control(bytes, Sender::kHub));
  *control.mutable_marks()->add_marks() = mark(pb::MARK_KIND_NOTE, 2, "bad");
  bytes.clear();
  encode_control(control, bytes);
  EXPECT_FALSE(decode_control(bytes, Sender::kHub));
}

TEST(MarkCheck, a_viewer_takes_marks_of_a_later_version) {
  pb::Marks message;
  *message.add_marks() = mark(static_cast<pb::MarkKind>(99), 3, "new");
  EXPECT_TRUE(check_marks(message));
  message.mutable_marks(0)->set_points(0, std::numeric_limits<float>::infinity());
  EXPECT_FALSE(check_marks(message));
}

TEST(MarkCheck, a_message_has_no_more_marks_than_a_room) {
  pb::Marks many;
  pb::RemoveMarks removal;
  for (int i = 0; i < kMaxMarks; ++i) {
    *many.add_marks() = mark(pb::MARK_KIND_NOTE, 1, "a");
    removal.add_ids(1);
  }
  EXPECT_TRUE(check_marks(many));
  EXPECT_TRUE(check_remove_marks(removal));
  *many.add_marks() = mark(pb::MARK_KIND_NOTE, 1, "a");
  removal.add_ids(1);
  EXPECT_FALSE(check_marks(many));
  EXPECT_FALSE(check_remove_marks(removal));
}

}  // namespace
}  // namespace roomcast::wire
