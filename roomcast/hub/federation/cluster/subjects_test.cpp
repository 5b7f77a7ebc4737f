// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/subjects.h"

#include <set>

#include <gtest/gtest.h>

namespace roomcast::hub::federation {
namespace {

constexpr HubId kHub{0x0123456789abcdef};

TEST(Subjects, a_room_of_any_name_is_one_word_and_is_read_back) {
  for (const std::string room : {"lab", "my room.2", "Küche *>", "=", ""}) {
    const std::string subject = frames_subject(room, kHub);
    EXPECT_EQ(subject.find_first_of(" *>"), std::string::npos) << subject;
    const auto read = read_subject(subject);
    ASSERT_TRUE(read) << subject;
    EXPECT_EQ(read->subject, Subject::kFrames);
    EXPECT_EQ(read->room, room);
    EXPECT_EQ(read->hub, kHub);
  }
}

TEST(Subjects, news_inbox_and_heartbeats_are_distinguished) {
  EXPECT_EQ(read_subject(news_subject("lab"))->room, "lab");
  EXPECT_EQ(read_subject(news_subject("lab"))->subject, Subject::kNews);
  EXPECT_EQ(read_subject(poses_subject("lab"))->room, "lab");
  EXPECT_EQ(read_subject(poses_subject("lab"))->subject, Subject::kPoses);
  EXPECT_EQ(read_subject(inbox_subject(kHub))->subject, Subject::kInbox);
  EXPECT_EQ(read_subject(kHeartbeatSubject)->subject, Subject::kHeartbeat);
  EXPECT_EQ(read_subject(kRevokedSubject)->subject, Subject::kRevoked);
}

TEST(Subjects, plain_names_stay_readable_for_permissions) {
  EXPECT_EQ(news_subject("lab-1"), "roomcast.room.lab-1.news");
  EXPECT_EQ(all_frames_subject("lab"), "roomcast.room.lab.frames.*");
}

TEST(Subjects, ignores_subjects_of_other_programs) {
  for (const char* subject :
       {"", "roomcast", "roomcast.room", "roomcast.room.lab", "roomcast.room.lab.news.more",
        "roomcast.room.la=b.news", "roomcast.room.la=zz.news", "roomcast.room.lab.frames.",
        "roomcast.room.lab.frames.xyz", "roomcast.room.lab.frames.1.2", "other.hubs"}) {
    EXPECT_FALSE(read_subject(subject).has_value()) << subject;
  }
}

TEST(HubId, is_new_each_time_and_never_zero) {
  std::set<HubId> ids;
  for (int i = 0; i < 100; ++i) ids.insert(new_hub_id());
  EXPECT_EQ(ids.size(), 100u);
  EXPECT_FALSE(ids.contains(HubId{}));
  EXPECT_EQ(to_string(kHub), "0123456789abcdef");
}

}  // namespace
}  // namespace roomcast::hub::federation
