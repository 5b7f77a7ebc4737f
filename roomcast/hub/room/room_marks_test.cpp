// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "roomcast/hub/access/author_tag.h"
#include "roomcast/hub/room/room_test_fixture.h"

namespace roomcast::hub {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

const Entry kMarking = {.may_mark = true};
const Entry kAdmin = {.may_place = true, .may_mark = true};

pb::Join author_join(const std::string& name, const std::string& key = "") {
  pb::Join join = viewer_join(name);
  join.mutable_viewer()->set_author_key(key);
  return join;
}

pb::Control note_message(const std::string& text = "mind the step") {
  pb::Control control;
  pb::Mark& mark = *control.mutable_mark();
  mark.set_kind(pb::MARK_KIND_NOTE);
  for (const float metres : {1.f, 0.f, -2.f}) mark.add_points(metres);
  mark.set_text(text);
  return control;
}

pb::Control removal_message(std::uint32_t id) {
  pb::Control control;
  control.mutable_remove_marks()->add_ids(id);
  return control;
}

pb::Control guide_message_of(bool on) {
  pb::Control control;
  control.mutable_guide()->set_on(on);
  return control;
}

pb::Marks sent_marks(const RoomActions& actions) {
  const auto sent = messages(actions, pb::Control::kMarks);
  return sent.empty() ? pb::Marks() : sent.back().message.marks();
}

TEST_F(RoomTest, a_mark_is_sent_to_all_viewers_with_its_author_and_saved) {
  const auto ada = enter(author_join("Ada", "secret"), 0s, kMarking);
  const auto bob = enter(viewer_join("Bob"));
  pb::Control given = note_message();
  given.mutable_mark()->set_author("Mallory");
  given.mutable_mark()->set_author_tag(7);
  given.mutable_mark()->set_id(99);
  const auto told = room.control(ada, given, at(1s));
  const auto sent = messages(told, pb::Control::kMarks);
  ASSERT_THAT(sent, SizeIs(1));
  EXPECT_THAT(sent[0].to, testing::UnorderedElementsAre(ada, bob));
  const pb::Mark& mark = sent[0].message.marks().marks(0);
  EXPECT_EQ(mark.id(), 1u);
  EXPECT_EQ(mark.author(), "Ada");
  EXPECT_EQ(mark.author_tag(), author_tag_of("lab", "secret"));
  EXPECT_NE(mark.color_rgb(), 0u);
  EXPECT_FALSE(sent[0].message.marks().all());
  const auto saved = all<SaveMarks>(told);
  ASSERT_THAT(saved, SizeIs(1));
  EXPECT_EQ(saved[0].added[0].SerializeAsString(), mark.SerializeAsString());
}

TEST_F(RoomTest, a_newcomer_gets_all_marks_and_its_own_tag) {
  const auto ada = enter(author_join("Ada", "secret"), 0s, kMarking);
  EXPECT_TRUE(messages(actions, pb::Control::kMarks).empty()) << "there are none yet";
  (void)room.control(ada, note_message("one"), at(1s));
  (void)room.control(ada, note_message("two"), at(1s));
  (void)room.leave(ada, at(2s));
  enter(author_join("Ada again", "secret"), 3s, kMarking);
  const auto marks = sent_marks(actions);
  EXPECT_TRUE(marks.all());
  ASSERT_EQ(marks.marks_size(), 2);
  const auto welcome = messages(actions, pb::Control::kWelcome)[0].message.welcome();
  EXPECT_EQ(welcome.author_tag(), marks.marks(0).author_tag());
  EXPECT_TRUE(welcome.may_mark());
}

TEST_F(RoomTest, marks_of_before_the_hubs_start_are_there) {
  pb::Mark mark = note_message("kept").mark();
  mark.set_id(5);
  room.remember({.marks = {mark}});
  enter(viewer_join("Ada"));
  EXPECT_EQ(sent_marks(actions).marks(0).text(), "kept");
}

TEST_F(RoomTest, only_those_with_the_right_leave_marks) {
  const auto guest = enter(viewer_join("Ada"));
  const auto told = room.control(guest, note_message(), at(1s));
  ASSERT_THAT(told, SizeIs(1));
  EXPECT_THAT(all<SendControl>(told)[0].to, ElementsAre(guest));
  EXPECT_THAT(sent_marks(told).refusal(), HasSubstr("does not let you"));
  const auto sensor = enter(sensor_join("s0"));
  EXPECT_THAT(all<Disconnect>(room.control(sensor, note_message(), at(1s))), SizeIs(1));
}

TEST_F(RoomTest, a_mark_that_breaks_a_limit_is_refused_to_its_author_alone_who_stays) {
  const auto ada = enter(viewer_join("Ada"), 0s, kMarking);
  pb::Control endless = note_message();
  endless.mutable_mark()->set_kind(pb::MARK_KIND_SKETCH);
  endless.mutable_mark()->clear_text();
  for (int i = 0; i < 3'000'000; ++i) endless.mutable_mark()->add_points(0);
  const auto told = room.control(ada, endless, at(1s));
  ASSERT_THAT(told, SizeIs(1));
  EXPECT_THAT(sent_marks(told).refusal(), HasSubstr("1000001 points, and a mark may have 512"));
  EXPECT_THAT(all<SaveMarks>(room.control(ada, note_message(), at(1s))), SizeIs(1));
}

TEST_F(RoomTest, who_marks_too_fast_has_to_wait_a_moment) {
  const auto ada = enter(viewer_join("Ada"), 0s, kMarking);
  int taken = 0;
  for (int i = 0; i < 60; ++i)
    taken += all<SaveMarks>(room.control(ada, note_message(), at(1s))).size();
  EXPECT_EQ(taken, 25);
  EXPECT_THAT(sent_marks(room.control(ada, note_message(), at(1s))).refusal(), HasSubstr("wait"));
  EXPECT_THAT(all<SaveMarks>(room.control(ada, note_message(), at(30s))), SizeIs(1));
}

TEST_F(RoomTest, a_mark_is_removed_by_its_author_or_an_admin_and_by_nobody_else) {
  const auto ada = enter(author_join("Ada", "secret"), 0s, kMarking);
  const auto bob = enter(author_join("Bob", "other"), 0s, kMarking);
  const auto admin = enter(viewer_join("Eve"), 0s, kAdmin);
  for (int i = 0; i < 2; ++i) (void)room.control(ada, note_message(), at(1s));
  const auto refused = room.control(bob, removal_message(1), at(2s));
  EXPECT_THAT(sent_marks(refused).refusal(), HasSubstr("only its author"));
  EXPECT_TRUE(all<SaveMarks>(refused).empty());
  const auto removed = room.control(ada, removal_message(1), at(2s));
  EXPECT_THAT(sent_marks(removed).removed(), ElementsAre(1u));
  EXPECT_THAT(all<SaveMarks>(removed)[0].removed, ElementsAre(1u));
  EXPECT_THAT(sent_marks(room.control(admin, removal_message(2), at(2s))).removed(),
              ElementsAre(2u));
}

TEST_F(RoomTest, an_admin_guides_until_they_end_it_or_leave) {
  const auto admin = enter(viewer_join("Eve"), 0s, kAdmin);  // viewer 1
  const auto ada = enter(viewer_join("Ada"));
  const auto guide_of = [](const RoomActions& told) {
    const auto sent = messages(told, pb::Control::kGuide);
    return sent.empty() ? -1 : static_cast<int>(sent.back().message.guide().viewer_id());
  };
  const auto begun = room.control(admin, guide_message_of(true), at(1s));
  EXPECT_EQ(guide_of(begun), 1);
  EXPECT_THAT(messages(begun, pb::Control::kGuide)[0].to,
              testing::UnorderedElementsAre(admin, ada));
  enter(viewer_join("Bob"), 2s);
  EXPECT_EQ(guide_of(actions), 1) << "a newcomer is told, too";
  EXPECT_EQ(guide_of(room.leave(admin, at(3s))), 0);
  enter(viewer_join("Carl"), 4s);
  EXPECT_EQ(guide_of(actions), -1);
  EXPECT_EQ(guide_of(room.leave(ada, at(5s))), -1) << "who did not guide ends nothing";
}

TEST_F(RoomTest, only_an_admin_guides) {
  const auto ada = enter(viewer_join("Ada"), 0s, kMarking);
  EXPECT_THAT(all<Disconnect>(room.control(ada, guide_message_of(true), at(1s))), SizeIs(1));
}

}  // namespace
}  // namespace roomcast::hub
