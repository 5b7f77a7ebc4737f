// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/room_store.h"

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub {
namespace {

TEST(RoomStore, keeps_entries_across_a_restart) {
  const TemporaryFolder folder;
  ASSERT_TRUE(RoomStore(**Database::open(folder / "hub.sqlite"))
                  .save({.name = "lab", .listed = false, .view = AccessRule::kToken})
                  .ok());
  const auto database = *Database::open(folder / "hub.sqlite");
  const auto rooms = RoomStore(*database).load();
  ASSERT_EQ(rooms->size(), 1U);
  EXPECT_FALSE(rooms->at(0).listed);
  EXPECT_EQ(rooms->at(0).view, AccessRule::kToken);
}

TEST(RoomStore, replaces_settings_and_removes_forgotten_rooms) {
  const auto database = *Database::open(std::nullopt);
  RoomStore rooms(*database);
  ASSERT_TRUE(rooms.save({.name = "lab", .max_viewers = 3}).ok());
  ASSERT_TRUE(rooms.save({.name = "lab", .max_viewers = 4}).ok());
  ASSERT_EQ(rooms.load()->size(), 1U);
  EXPECT_EQ(rooms.load()->at(0).max_viewers, 4U);
  ASSERT_TRUE(rooms.forget("lab").ok());
  EXPECT_TRUE(rooms.load()->empty());
}

TEST(RoomStore, leaves_out_invalid_entries) {
  const auto database = *Database::open(std::nullopt);
  ASSERT_TRUE(database
                  ->run("INSERT INTO rooms VALUES ('a', 'nonsense'), ('b', '{\"name\": \"b\"}'),"
                        " ('c', '{\"view\": 3}')")
                  .ok());
  const auto rooms = *RoomStore(*database).load();
  ASSERT_EQ(rooms.size(), 1U);
  EXPECT_EQ(rooms[0].name, "b");
}

}  // namespace
}  // namespace roomcast::hub
