// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/hub_directory.h"

#include <limits>

#include <gtest/gtest.h>

namespace roomcast::hub::federation {
namespace {

using namespace std::chrono_literals;

constexpr HubId kOwnHub{5}, kLowerHub{3}, kHigherHub{8};

std::uint64_t ns(HostTime time) {
  return static_cast<std::uint64_t>(time.time_since_epoch().count());
}

pb::Heartbeat heartbeat_of(HubId hub, HostTime sent = {}) {
  pb::Heartbeat heartbeat;
  heartbeat.set_hub(hub.value);
  heartbeat.set_sent_ns(ns(sent));
  heartbeat.set_aligns(true);
  return heartbeat;
}

pb::RoomHere& add_room(pb::Heartbeat& heartbeat, std::uint32_t sensors) {
  pb::RoomHere& here = *heartbeat.add_rooms();
  here.set_room("lab");
  here.set_revision(1);
  here.set_sensors(sensors);
  return here;
}

TEST(HubDirectory, lists_a_hub_until_it_is_silent_or_leaves) {
  HubDirectory directory(kOwnHub);
  const HostTime start(100s);
  EXPECT_TRUE(directory.update(heartbeat_of(kLowerHub), start));
  EXPECT_TRUE(directory.update(heartbeat_of(kHigherHub), start + kGoneAfter));
  EXPECT_TRUE(directory.remove_gone(start + kGoneAfter).empty());
  EXPECT_EQ(directory.remove_gone(start + kGoneAfter + 1ms), std::vector{kLowerHub});
  EXPECT_TRUE(directory.remove_gone(start + kGoneAfter + 1ms).empty()) << "once";
  auto leaving = heartbeat_of(kHigherHub);
  leaving.set_leaves(true);
  EXPECT_TRUE(directory.update(leaving, start + kGoneAfter));
  EXPECT_EQ(directory.remove_gone(start + kGoneAfter), std::vector{kHigherHub});
  EXPECT_FALSE(directory.update(leaving, start)) << "an unknown hub cannot leave";
}

TEST(HubDirectory, rejects_own_and_invalid_heartbeats) {
  HubDirectory directory(kOwnHub);
  EXPECT_FALSE(directory.update(heartbeat_of(kOwnHub), {}));
  EXPECT_FALSE(directory.update(heartbeat_of(HubId{0}), {}));
  for (std::uint64_t id = 10; id < 10 + kMaxHubs; ++id)
    directory.update(heartbeat_of(HubId{id}), {});
  EXPECT_FALSE(directory.update(heartbeat_of(HubId{1'000}), {}));
  EXPECT_TRUE(directory.update(heartbeat_of(HubId{10}), {})) << "that one is known";
  EXPECT_EQ(directory.others().size(), kMaxHubs);
}

TEST(HubDirectory, heartbeats_that_answer_each_other_give_the_clock_offset) {
  constexpr auto kAhead = 7s;  // of the other hub's clock
  HubDirectory here(kOwnHub), there(kLowerHub);
  HostTime now(100s);
  for (int i = 0; i < 10; ++i, now += 150ms) {
    auto own = heartbeat_of(kOwnHub, now);
    here.write_heard(own);
    there.update(own, now + 2ms + kAhead);
    auto theirs = heartbeat_of(kLowerHub, now + 80ms + kAhead);
    there.write_heard(theirs);
    here.update(theirs, now + 82ms);
  }
  const auto estimate = here.find(kLowerHub)->clock.estimate();
  ASSERT_TRUE(estimate);
  EXPECT_LE(std::chrono::abs(estimate->room_minus_host - kAhead), 10us);
  EXPECT_GE(estimate->error, 2ms) << "half of what the way there and back takes";
  EXPECT_LE(estimate->error, 3ms);
}

TEST(HubDirectory, a_clock_offset_needs_an_answer) {
  HubDirectory directory(kOwnHub);
  directory.update(heartbeat_of(kLowerHub, HostTime(1s)), HostTime(2s));
  EXPECT_FALSE(directory.find(kLowerHub)->clock.estimate().has_value());
}

TEST(HubDirectory, ignores_an_answer_older_than_its_question) {
  HubDirectory directory(kOwnHub);
  auto heartbeat = heartbeat_of(kLowerHub, HostTime(1s));
  pb::Heard& heard = *heartbeat.add_heard();
  heard.set_hub(kOwnHub.value);
  heard.set_sent_ns(ns(HostTime(1s)));
  heard.set_received_ns(ns(HostTime(2s)));
  directory.update(heartbeat, HostTime(2s));
  EXPECT_FALSE(directory.find(kLowerHub)->clock.estimate().has_value());
}

TEST(HubDirectory, frames_are_wanted_while_any_hub_wants_them) {
  HubDirectory directory(kOwnHub);
  auto heartbeat = heartbeat_of(kLowerHub);
  add_room(heartbeat, 0).set_wants_frames(true);
  directory.update(heartbeat, {});
  EXPECT_TRUE(directory.is_wanted("lab"));
  EXPECT_FALSE(directory.is_wanted("kitchen"));
  directory.update(heartbeat_of(kLowerHub), {});
  EXPECT_FALSE(directory.is_wanted("lab"));
}

TEST(HubDirectory, lists_the_hubs_that_have_a_room) {
  HubDirectory directory(kOwnHub);
  for (const auto& [hub, url] : {std::pair(kLowerHub, "wss://b"), std::pair(kHigherHub, "wss://a"),
                                 std::pair(HubId{9}, ""), std::pair(HubId{10}, "wss://other")}) {
    auto heartbeat = heartbeat_of(hub);
    heartbeat.set_public_url(url);
    heartbeat.add_all_rooms(hub == HubId{10} ? "kitchen" : "lab");
    directory.update(heartbeat, {});
    heartbeat.clear_all_rooms();  // not in every heartbeat
    directory.update(heartbeat, {});
  }
  EXPECT_EQ(directory.urls_with("lab"), (std::vector<std::string>{"wss://a", "wss://b"}));
}

TEST(HubDirectory, lists_much_less_busy_hubs_least_busy_first) {
  HubDirectory directory(kOwnHub);
  const auto hear = [&](std::uint64_t id, const std::string& url, float load, float cores,
                        const std::string& room = "lab") {
    auto heartbeat = heartbeat_of(HubId{id});
    heartbeat.set_public_url(url);
    heartbeat.set_load(load);
    heartbeat.set_cores(cores);
    heartbeat.add_all_rooms(room);
    directory.update(heartbeat, {});
  };
  hear(11, "wss://half", 0.8F, 2);
  hear(12, "wss://idle", 0, 2);
  hear(13, "wss://nearly-as-busy", 1, 2);
  hear(14, "", 0, 2);
  hear(15, "wss://silent", 0, 0);
  hear(16, "wss://nonsense", std::numeric_limits<float>::quiet_NaN(), 2);
  hear(17, "wss://another-room", 0, 2, "kitchen");
  auto own = heartbeat_of(kOwnHub);
  own.set_load(3.2F);
  own.set_cores(4);
  EXPECT_EQ(directory.less_busy_with("lab", own),
            (std::vector<std::string>{"wss://idle", "wss://half"}));
  EXPECT_FALSE(busy_share(heartbeat_of(kOwnHub)).has_value());
}

/// The owner that `who` computes from the heartbeats of all hubs; every hub must get the same
/// result.
std::optional<HubId> owner_as_seen_by(HubId who, const std::vector<pb::Heartbeat>& hubs) {
  HubDirectory directory(who);
  pb::Heartbeat own;
  for (const auto& hub : hubs) {
    directory.update(hub, {});
    if (HubId{hub.hub()} == who) own = hub;
  }
  return owner_of("lab", own, directory);
}

TEST(RoomOwner, is_the_lowest_id_with_sensors_on_all_hubs) {
  std::vector hubs{heartbeat_of(kOwnHub), heartbeat_of(kLowerHub), heartbeat_of(kHigherHub)};
  add_room(hubs[0], 1);
  add_room(hubs[1], 0);
  add_room(hubs[2], 2);
  for (const HubId who : {kOwnHub, kLowerHub, kHigherHub})
    EXPECT_EQ(owner_as_seen_by(who, hubs), kOwnHub);
  hubs[0].mutable_rooms(0)->set_sensors(0);
  for (const HubId who : {kOwnHub, kLowerHub, kHigherHub})
    EXPECT_EQ(owner_as_seen_by(who, hubs), kHigherHub);
}

TEST(RoomOwner, is_a_hub_with_an_aligner_and_sensors) {
  std::vector hubs{heartbeat_of(kOwnHub), heartbeat_of(kLowerHub)};
  EXPECT_EQ(owner_as_seen_by(kOwnHub, hubs), std::nullopt) << "no hub has the room";
  add_room(hubs[1], 0).set_revision(0);
  EXPECT_EQ(owner_as_seen_by(kOwnHub, hubs), std::nullopt) << "it has never had a sensor";
  hubs[1].mutable_rooms(0)->set_revision(1);
  EXPECT_EQ(owner_as_seen_by(kOwnHub, hubs), kLowerHub);
  hubs[1].set_aligns(false);
  EXPECT_EQ(owner_as_seen_by(kOwnHub, hubs), std::nullopt);
}

}  // namespace
}  // namespace roomcast::hub::federation
