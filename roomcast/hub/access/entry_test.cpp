// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/entry.h"

#include <map>

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

pb::Join viewer(const std::string& room, bool records = false) {
  pb::Join join;
  join.set_room(room);
  join.mutable_viewer()->set_records(records);
  return join;
}

pb::Join sensor(const std::string& room, const std::string& name) {
  pb::Join join;
  join.set_room(room);
  join.set_name(name);
  join.mutable_sensor();
  return join;
}

pb::Join aligner(const std::string& room) {
  pb::Join join;
  join.set_room(room);
  join.mutable_aligner();
  return join;
}

Claims claims(const std::string& room, TokenRole role, const std::string& name = "") {
  return {.id = "t1", .grant = {.room = room, .role = role, .name = name}, .expires_at = 99};
}

class EntryTest : public testing::Test {
 protected:
  EntryTest() {
    rooms["open"] = {.name = "open"};
    rooms["lab"] = {.name = "lab",
                    .send = AccessRule::kToken,
                    .view = AccessRule::kToken,
                    .record = AccessRule::kAdmin};
    rooms["cellar"] = {
        .name = "cellar", .listed = false, .send = AccessRule::kToken, .view = AccessRule::kToken};
    rooms["registry"] = {.name = "registry", .listed = false};
  }

  Verdict<Entry> decide(const pb::Join& join, const std::optional<Claims>& shown = {}) {
    const FindRoom find = [this](const std::string& name) -> const RoomSettings* {
      const auto found = rooms.find(name);
      return found == rooms.end() ? nullptr : &found->second;
    };
    return decide_entry(join, shown ? &*shown : nullptr, find, only_listed);
  }
  pb::ErrorCode fault(const pb::Join& join, const std::optional<Claims>& shown = {}) {
    const auto verdict = decide(join, shown);
    const Refusal* why = refusal(verdict);
    return why == nullptr ? pb::ERROR_UNSPECIFIED : why->code;
  }

  std::map<std::string, RoomSettings> rooms;
  std::string only_listed;
};

TEST_F(EntryTest, an_open_room_admits_everybody_without_placing_rights) {
  EXPECT_EQ(fault(viewer("open")), pb::ERROR_UNSPECIFIED);
  EXPECT_EQ(fault(sensor("open", "left")), pb::ERROR_UNSPECIFIED);
  EXPECT_EQ(fault(aligner("open")), pb::ERROR_UNAUTHENTICATED);
  EXPECT_FALSE(std::get<Entry>(decide(viewer("open"))).may_place);
}

TEST_F(EntryTest, who_may_view_may_speak_unless_the_room_says_otherwise) {
  const auto may_speak = [this](const pb::Join& join, const std::optional<Claims>& shown = {}) {
    return std::get<Entry>(decide(join, shown)).may_speak;
  };
  EXPECT_TRUE(may_speak(viewer("open")));
  EXPECT_TRUE(may_speak(viewer("lab"), claims("lab", TokenRole::kViewer)));
  rooms["lab"].speak = rooms["open"].speak = AccessRule::kAdmin;
  EXPECT_FALSE(may_speak(viewer("open")));
  EXPECT_FALSE(may_speak(viewer("lab"), claims("lab", TokenRole::kViewer)));
  EXPECT_TRUE(may_speak(viewer("lab"), claims("lab", TokenRole::kAdmin)));
}

TEST_F(EntryTest, a_sensors_microphone_is_heard_where_everybody_may_speak) {
  const auto may_speak = [this] {
    return std::get<Entry>(decide(sensor("open", "left"))).may_speak;
  };
  EXPECT_TRUE(may_speak());
  rooms["open"].speak = AccessRule::kAdmin;
  EXPECT_FALSE(may_speak());
}

TEST_F(EntryTest, recorders_and_relaying_hubs_do_not_speak) {
  pb::Join hub = viewer("open");
  hub.mutable_viewer()->set_relays(true);
  for (const pb::Join& join : {hub, viewer("open", true)})
    EXPECT_FALSE(std::get<Entry>(decide(join)).may_speak);
}

TEST_F(EntryTest, a_refusal_without_token_asks_for_one) {
  EXPECT_EQ(fault(viewer("lab")), pb::ERROR_UNAUTHENTICATED);
  EXPECT_EQ(fault(sensor("lab", "left")), pb::ERROR_UNAUTHENTICATED);
}

TEST_F(EntryTest, a_token_opens_its_room_in_its_role) {
  EXPECT_EQ(fault(viewer("lab"), claims("lab", TokenRole::kViewer)), pb::ERROR_UNSPECIFIED);
  EXPECT_EQ(fault(sensor("lab", "left"), claims("lab", TokenRole::kSensor)), pb::ERROR_UNSPECIFIED);
}

TEST_F(EntryTest, a_token_for_another_room_is_refused_whether_that_room_exists_or_not) {
  for (const char* room : {"lab", "open", "cellar", "nowhere"}) {
    EXPECT_EQ(fault(viewer(room), claims("kitchen", TokenRole::kViewer)), pb::ERROR_WRONG_ROOM);
  }
}

TEST_F(EntryTest, a_token_for_another_role_is_refused) {
  EXPECT_EQ(fault(sensor("lab", "left"), claims("lab", TokenRole::kViewer)), pb::ERROR_WRONG_ROLE);
  EXPECT_EQ(fault(viewer("lab"), claims("lab", TokenRole::kSensor)), pb::ERROR_WRONG_ROLE);
  EXPECT_EQ(fault(aligner("lab"), claims("lab", TokenRole::kViewer)), pb::ERROR_WRONG_ROLE);
}

TEST_F(EntryTest, relaying_needs_a_hub_token_where_viewing_needs_a_viewer_token) {
  pb::Join hub = viewer("lab");
  hub.mutable_viewer()->set_relays(true);
  EXPECT_EQ(fault(hub), pb::ERROR_UNAUTHENTICATED);
  EXPECT_EQ(fault(hub, claims("lab", TokenRole::kViewer)), pb::ERROR_WRONG_ROLE);
  EXPECT_EQ(fault(hub, claims("lab", TokenRole::kHub)), pb::ERROR_UNSPECIFIED);
  EXPECT_EQ(fault(hub, claims("lab", TokenRole::kAdmin)), pb::ERROR_UNSPECIFIED);
  EXPECT_EQ(fault(viewer("lab"), claims("lab", TokenRole::kHub)), pb::ERROR_WRONG_ROLE);
  hub.set_room("open");
  EXPECT_EQ(fault(hub), pb::ERROR_UNSPECIFIED) << "as anyone may look there";
}

TEST_F(EntryTest, who_plays_recordings_is_an_admin) {
  pb::Join player = viewer("open");
  player.mutable_viewer()->set_plays("monday");
  EXPECT_EQ(fault(player), pb::ERROR_UNAUTHENTICATED);
  EXPECT_EQ(fault(player, claims("open", TokenRole::kViewer)), pb::ERROR_WRONG_ROLE);
  rooms["open"].speak = AccessRule::kNobody;
  const auto admitted = decide(player, claims("open", TokenRole::kAdmin));
  EXPECT_FALSE(std::get<Entry>(admitted).may_speak) << "as the room's rules are";
}

TEST_F(EntryTest, an_admin_may_do_everything_in_its_room) {
  const Claims admin = claims("lab", TokenRole::kAdmin);
  EXPECT_EQ(fault(aligner("lab"), admin), pb::ERROR_UNSPECIFIED);
  EXPECT_EQ(fault(sensor("lab", "left"), admin), pb::ERROR_UNSPECIFIED);
  EXPECT_TRUE(std::get<Entry>(decide(viewer("lab", true), admin)).may_place);
  EXPECT_EQ(fault(viewer("open"), admin), pb::ERROR_WRONG_ROOM);
  EXPECT_EQ(fault(viewer("cellar"), claims("*", TokenRole::kAdmin)), pb::ERROR_UNSPECIFIED);
}

TEST_F(EntryTest, only_an_admin_token_can_be_for_all_rooms) {
  EXPECT_EQ(fault(viewer("lab"), claims("*", TokenRole::kViewer)), pb::ERROR_WRONG_ROOM);
}

TEST_F(EntryTest, a_private_room_looks_nonexistent_to_strangers) {
  for (const auto& [there, nowhere] :
       {std::pair{viewer("cellar"), viewer("nowhere")},
        std::pair{sensor("cellar", "left"), sensor("nowhere", "left")},
        std::pair{aligner("cellar"), aligner("nowhere")}}) {
    const auto a = decide(there), b = decide(nowhere);
    ASSERT_NE(refusal(a), nullptr);
    EXPECT_EQ(refusal(a)->code, refusal(b)->code);
    EXPECT_EQ(refusal(a)->sentence, refusal(b)->sentence);
  }
}

TEST_F(EntryTest, an_unlisted_room_can_be_open) {
  EXPECT_EQ(fault(viewer("registry")), pb::ERROR_UNSPECIFIED);
  EXPECT_FALSE(may_know_of(rooms["registry"], nullptr));
}

TEST_F(EntryTest, a_named_sensor_token_admits_that_sensor_only) {
  const Claims token = claims("lab", TokenRole::kSensor, "left");
  EXPECT_EQ(fault(sensor("lab", "right"), token), pb::ERROR_WRONG_ROLE);
  EXPECT_TRUE(std::get<Entry>(decide(sensor("lab", "left"), token)).takes_over_name);
}

TEST_F(EntryTest, the_room_decides_the_right_to_record) {
  EXPECT_EQ(fault(viewer("lab", true), claims("lab", TokenRole::kViewer)), pb::ERROR_NOT_ALLOWED);
  EXPECT_EQ(fault(viewer("open", true)), pb::ERROR_UNSPECIFIED);
  rooms["open"].record = AccessRule::kNobody;
  EXPECT_EQ(fault(viewer("open", true)), pb::ERROR_NOT_ALLOWED);
  EXPECT_EQ(fault(viewer("open", true), claims("open", TokenRole::kAdmin)), pb::ERROR_NOT_ALLOWED);
}

TEST_F(EntryTest, the_room_decides_who_may_leave_marks) {
  const auto may_mark = [&](const std::string& room, const std::optional<Claims>& shown = {}) {
    return std::get<Entry>(decide(viewer(room), shown)).may_mark;
  };
  EXPECT_TRUE(may_mark("open"));
  rooms["open"].mark = AccessRule::kAdmin;
  EXPECT_FALSE(may_mark("open"));
  EXPECT_TRUE(may_mark("open", claims("open", TokenRole::kAdmin)));
  rooms["lab"].mark = AccessRule::kToken;
  EXPECT_TRUE(may_mark("lab", claims("lab", TokenRole::kViewer)));
  rooms["open"].mark = AccessRule::kNobody;
  EXPECT_FALSE(may_mark("open", claims("open", TokenRole::kAdmin)));
}

TEST_F(EntryTest, a_closed_room_admits_no_client) {
  rooms["lab"].view = AccessRule::kNobody;
  EXPECT_EQ(fault(viewer("lab"), claims("lab", TokenRole::kAdmin)), pb::ERROR_NOT_ALLOWED);
}

TEST_F(EntryTest, an_empty_room_name_means_the_tokens_or_the_only_room) {
  EXPECT_EQ(fault(viewer("")), pb::ERROR_NO_SUCH_ROOM);
  EXPECT_EQ(std::get<Entry>(decide(viewer(""), claims("lab", TokenRole::kViewer))).room, "lab");
  only_listed = "open";
  EXPECT_EQ(std::get<Entry>(decide(viewer(""))).room, "open");
}

}  // namespace
}  // namespace roomcast::hub
