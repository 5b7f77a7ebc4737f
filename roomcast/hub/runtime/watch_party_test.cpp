// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/watch_party.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

HostTime after(nanoseconds time) {
  return HostTime(1h + time);
}

class WatchPartiesTest : public testing::Test {
 protected:
  WatchParties::View visit(const std::string& key, nanoseconds time,
                           std::optional<Playing> wants = {}, const std::string& recording = "r") {
    auto view = parties.visit(
        recording, {.key = key, .name = "name of " + key, .head = {1, 2, 3}, .wants = wants},
        after(time));
    EXPECT_TRUE(view.has_value());
    return view.value_or(WatchParties::View{});
  }
  WatchParties parties;
};

TEST_F(WatchPartiesTest, everybody_sees_the_others_of_the_same_recording) {
  EXPECT_TRUE(visit("a", 0s).others.empty());
  const auto seen = visit("b", 1s).others;
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].name, "name of a");
  EXPECT_EQ(seen[0].head[2], 3);
  EXPECT_TRUE(visit("c", 1s, {}, "another").others.empty());
}

TEST_F(WatchPartiesTest, what_one_wants_counts_for_all_and_goes_on_with_the_time) {
  EXPECT_EQ(visit("a", 0s).change, 0u) << "nobody has wanted anything";
  EXPECT_TRUE(visit("a", 1s, Playing{.position_s = 10, .speed = 2}).is_own);
  auto view = visit("b", 3s);
  EXPECT_EQ(view.change, 1u);
  EXPECT_FALSE(view.is_own);
  EXPECT_EQ(view.by, "name of a");
  EXPECT_DOUBLE_EQ(view.playing.position_s, 14);
  (void)visit("b", 4s, Playing{.position_s = 5, .paused = true});
  view = visit("a", 6s);
  EXPECT_EQ(view.change, 2u);
  EXPECT_DOUBLE_EQ(view.playing.position_s, 5);
}

TEST_F(WatchPartiesTest, who_does_not_ask_any_more_is_gone_and_so_is_a_party_of_nobody) {
  (void)visit("a", 0s, Playing{.position_s = 10});
  EXPECT_EQ(visit("b", 4s).others.size(), 1u);
  EXPECT_TRUE(visit("b", 6s).others.empty());
  EXPECT_EQ(visit("c", 20s).change, 0u);
}

TEST_F(WatchPartiesTest, who_leaves_is_gone_at_once) {
  (void)visit("a", 0s, Playing{.position_s = 10});
  EXPECT_TRUE(
      parties.visit("r", {.key = "a", .name = "", .leaves = true}, after(100ms)).has_value());
  const auto seen = visit("b", 200ms);
  EXPECT_TRUE(seen.others.empty());
  EXPECT_EQ(seen.change, 0u) << "nobody is left who wanted anything";
}

TEST_F(WatchPartiesTest, are_bounded) {
  for (std::size_t i = 0; i < WatchParties::kMaxWatchers; ++i) (void)visit(std::to_string(i), 0s);
  EXPECT_FALSE(parties.visit("r", {.key = "more", .name = ""}, after(0s)).has_value());
  EXPECT_TRUE(parties.visit("r", {.key = "0", .name = ""}, after(0s)).has_value());
  for (std::size_t i = 1; i < WatchParties::kMaxParties; ++i)
    (void)visit("a", 0s, {}, "r" + std::to_string(i));
  EXPECT_FALSE(parties.visit("one more", {.key = "a", .name = ""}, after(0s)).has_value());
}

}  // namespace
}  // namespace roomcast::hub
