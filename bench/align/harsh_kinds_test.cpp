// SPDX-License-Identifier: Apache-2.0
#include "bench/align/harsh_kinds.h"

#include <set>

#include <gtest/gtest.h>

#include "roomcast/simulator/scene/room.h"

namespace roomcast::bench {
namespace {

TEST(HarshKinds, no_room_is_in_both_parts_and_all_rooms_are_in_one) {
  std::set<std::string> development, judged;
  for (const HarshKind& kind : harsh_kinds(HarshPart::kDevelopment, 1))
    development.insert(kind.room);
  for (const HarshKind& kind : harsh_kinds(HarshPart::kJudged, 1)) judged.insert(kind.room);
  for (const std::string& room : development) EXPECT_FALSE(judged.contains(room)) << room;
  for (const auto* names : {&development, &judged}) EXPECT_EQ(names->size(), 7u);
  for (const auto name : simulator::kSceneNames)
    EXPECT_TRUE(development.contains(std::string(name)) || judged.contains(std::string(name)));
  for (const auto name : simulator::kHarshSceneNames)
    EXPECT_TRUE(development.contains(std::string(name)) || judged.contains(std::string(name)));
}

TEST(HarshKinds, a_choice_of_kinds_changes_no_seed) {
  const auto all = harsh_kinds(std::nullopt, 5);
  EXPECT_EQ(all.size(), 42u);
  std::set<std::uint64_t> seeds;
  for (const HarshKind& kind : all) seeds.insert(kind.seed);
  EXPECT_EQ(seeds.size(), all.size());
  const auto judged = harsh_kinds(HarshPart::kJudged, 5);
  EXPECT_EQ(judged.front().name(), all[21].name());
  EXPECT_EQ(judged.front().seed, all[21].seed);
  EXPECT_NE(harsh_kinds(std::nullopt, 6).front().seed, all.front().seed);
}

TEST(HarshKinds, are_chosen_by_room_by_sensors_or_by_both) {
  const auto all = harsh_kinds(std::nullopt, 1);
  EXPECT_EQ(chosen_kinds(all, {}).size(), all.size());
  EXPECT_EQ(chosen_kinds(all, {"office"}).size(), 3u);
  EXPECT_EQ(chosen_kinds(all, {"structured"}).size(), 14u);
  const auto one = chosen_kinds(all, {"office/tof"});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one.front().name(), "office/tof");
  EXPECT_TRUE(chosen_kinds(all, {"attic"}).empty());
}

TEST(HarshKinds, parts_have_names) {
  for (const HarshPart part : {HarshPart::kDevelopment, HarshPart::kJudged})
    EXPECT_EQ(harsh_part_named(name_of(part)), part);
  EXPECT_FALSE(harsh_part_named("all"));
}

}  // namespace
}  // namespace roomcast::bench
