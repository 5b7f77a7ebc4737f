// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/room_events.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

RoomEvent refusal_of(const std::string& name, const std::string& peer = "10.0.0.7:1") {
  return {.kind = "refused", .role = "viewer", .name = name, .peer = peer, .sentence = "no token"};
}

TEST(RoomEvents, come_in_pages_in_their_order) {
  RoomEvents events;
  EXPECT_EQ(events.after(0).newest, 0U);
  for (int i = 0; i < 250; ++i) events.add({.kind = "joined", .name = std::to_string(i)}, i);
  const auto page = events.after(0);
  ASSERT_EQ(page.events.size(), RoomEvents::kMaxPage);
  EXPECT_EQ(page.newest, 250U);
  EXPECT_EQ(page.events.front().name, "0");
  const auto rest = events.after(page.events.back().number);
  ASSERT_EQ(rest.events.size(), 50U);
  EXPECT_EQ(rest.events.back().name, "249");
  EXPECT_EQ(rest.events.back().at, 249);
  EXPECT_TRUE(events.after(250).events.empty());
}

TEST(RoomEvents, equal_refusals_count_as_one_that_keeps_its_id) {
  RoomEvents events;
  events.add(refusal_of("Eve", "10.0.0.7:1"), 1);
  events.add({.kind = "joined", .name = "Ada"}, 2);
  events.add(refusal_of("Eve", "10.0.0.7:2"), 3);
  events.add(refusal_of("Eve", "10.0.0.8:2"), 4);
  const auto page = events.after(0);
  ASSERT_EQ(page.events.size(), 3U);
  EXPECT_EQ(page.events[0].name, "Ada");
  EXPECT_EQ(page.events[1].times, 2U);
  EXPECT_EQ(page.events[1].id, 1U);
  EXPECT_EQ(page.events[1].number, 3U);
  EXPECT_EQ(page.events[1].at, 3);
}

TEST(RoomEvents, a_flood_of_refusals_hides_nothing_else) {
  RoomEvents events;
  events.add({.kind = "joined", .name = "Ada"}, 0);
  for (int i = 0; i < 5000; ++i) events.add(refusal_of(std::to_string(i)), i);
  const auto page = events.after(0);
  EXPECT_EQ(page.events.front().name, "Ada");
  std::size_t count = 0;
  for (auto next = page; !next.events.empty(); next = events.after(next.events.back().number))
    count += next.events.size();
  EXPECT_EQ(count, 1 + RoomEvents::kMaxRefusals);
}

TEST(RoomEvents, the_oldest_are_forgotten_and_sentences_have_an_end) {
  RoomEvents events;
  for (int i = 0; i < 1500; ++i) events.add({.kind = "left", .name = std::to_string(i)}, i);
  EXPECT_EQ(events.after(0).events.front().name, "500");
  std::string sentence(299, 'x');
  sentence += "\u00e9\u00e9";
  events.add({.kind = "left", .sentence = sentence}, 0);
  EXPECT_EQ(events.after(1500).events.front().sentence, std::string(299, 'x'));
}

}  // namespace
}  // namespace roomcast::hub
