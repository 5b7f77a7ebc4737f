// SPDX-License-Identifier: Apache-2.0
// Requests about marks, answered by a scripted hub. nudge_test.cpp tests proposals of poses,
// capi/people_test.cpp the answers of a real hub.
#include "roomcast/client/room_requests.h"

#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

class RoomRequests : public testing::Test {
 protected:
  RoomRequests() { network.start(); }
  ~RoomRequests() override {
    room.reset();
    network.finish([this] { hub.reset(); });
  }
  void join(bool lets_mark) {
    network.run([&] { hub->lets_mark = lets_mark; });
    auto opened = Subscriber::open({.hub_url = hub->url(), .room = {}, .name = "Ada", .log = {}});
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    room = std::move(*opened);
  }

  NetworkThread network;
  std::optional<FakeHub> hub{std::in_place, network.io()};
  std::unique_ptr<Subscriber> room;
  RoomMark note{.kind = MarkKind::kNote, .points_m = {{1, 2, 3}}, .text = "here", .author = {}};
};

TEST_F(RoomRequests, a_mark_that_no_hub_takes_is_not_sent) {
  join(true);
  note.text.clear();
  EXPECT_EQ(leave_mark(*room, note).error().message, "a note and a place need words");
  network.run([&] {
    for (const auto& message : hub->heard) EXPECT_FALSE(message.has_mark());
  });
}

TEST_F(RoomRequests, somebody_who_may_not_leave_marks_is_told_at_once) {
  join(false);
  EXPECT_EQ(leave_mark(*room, note).error().message, "this room does not let you leave marks");
}

TEST_F(RoomRequests, a_hub_that_does_not_answer_is_waited_for_only_so_long) {
  join(true);
  EXPECT_EQ(leave_mark(*room, note, {.time = 50ms}).error().code, ErrorCode::kUnavailable);
}

TEST_F(RoomRequests, without_a_connection_the_reason_is_told) {
  join(true);
  network.run([&] { hub->hang_up(); });
  while (room->snapshot()->connected) (void)room->wait_newer(room->snapshot()->revision, 10ms);
  EXPECT_NE(leave_mark(*room, note).error().message, "");
  EXPECT_EQ(remove_mark(*room, 1).error().code, ErrorCode::kUnavailable);
}

TEST_F(RoomRequests, a_mark_that_is_not_there_cannot_be_removed) {
  join(true);
  EXPECT_EQ(remove_mark(*room, 7).error().message, "the room has no mark 7");
}

}  // namespace
}  // namespace roomcast::client
