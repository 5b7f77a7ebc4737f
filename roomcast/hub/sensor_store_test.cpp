// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/sensor_store.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub {
namespace {

namespace fs = std::filesystem;

class SensorStoreTest : public testing::Test {
 protected:
  const TemporaryFolder folder;
};

KnownSensor sensor_at(const std::string& name, std::uint16_t id, double x) {
  return {name, SensorId{id}, KnownPose{{1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 4}};
}

TEST_F(SensorStoreTest, what_was_kept_is_there_after_a_restart) {
  const std::vector sensors = {sensor_at("left", 0, 1.25), sensor_at("right", 1, -3)};
  ASSERT_TRUE((*SensorStore::open(folder / "hub.sqlite"))->save("lab", sensors).ok());
  const auto store = *SensorStore::open(folder / "hub.sqlite");
  const auto kept = store->load("lab");
  ASSERT_TRUE(kept.ok()) << kept.error().message;
  ASSERT_EQ(kept->size(), 2U);
  EXPECT_EQ((*kept)[1].name, "right");
  EXPECT_EQ((*kept)[1].id, SensorId{1});
  EXPECT_EQ((*kept)[1].pose->world_from_depth, sensors[1].pose->world_from_depth);
  EXPECT_EQ((*kept)[1].pose->expected_error_mm, 4);
  EXPECT_TRUE(store->load("kitchen")->empty());
}

TEST_F(SensorStoreTest, a_newer_pose_takes_the_place_of_an_older_one) {
  const auto store = *SensorStore::open(folder / "hub.sqlite");
  ASSERT_TRUE(store->save("lab", std::vector{KnownSensor{"left", SensorId{3}}}).ok());
  EXPECT_FALSE(store->load("lab")->at(0).pose);
  ASSERT_TRUE(store->save("lab", std::vector{sensor_at("left", 3, 1)}).ok());
  ASSERT_TRUE(store->save("lab", std::vector{sensor_at("left", 3, 2)}).ok());
  const auto kept = store->load("lab");
  ASSERT_EQ(kept->size(), 1U);
  EXPECT_EQ((*kept)[0].pose->world_from_depth[3], 2);
}

TEST_F(SensorStoreTest, an_id_belongs_to_one_sensor_of_a_room) {
  const auto store = *SensorStore::open(folder / "hub.sqlite");
  ASSERT_TRUE(store->save("lab", std::vector{sensor_at("left", 0, 1)}).ok());
  ASSERT_TRUE(store->save("kitchen", std::vector{sensor_at("oven", 0, 1)}).ok());
  ASSERT_TRUE(store->save("lab", std::vector{sensor_at("door", 0, 1)}).ok());
  const auto kept = store->load("lab");
  ASSERT_EQ(kept->size(), 1U);
  EXPECT_EQ((*kept)[0].name, "door");
  EXPECT_EQ(store->load("kitchen")->at(0).name, "oven");
}

TEST_F(SensorStoreTest, names_are_data_and_nothing_else) {
  const std::string name = "'); DROP TABLE sensors; --";
  const auto store = *SensorStore::open(folder / "hub.sqlite");
  ASSERT_TRUE(store->save(name, std::vector{sensor_at(name, 0, 1)}).ok());
  EXPECT_EQ(store->load(name)->at(0).name, name);
}

TEST_F(SensorStoreTest, a_file_of_something_else_is_refused) {
  std::ofstream(folder / "hub.sqlite") << std::string(5000, 'x');
  const auto opened = SensorStore::open(folder / "hub.sqlite");
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().message.find("hub.sqlite"), std::string::npos);
  EXPECT_FALSE(SensorStore::open(folder / "no" / "such" / "folder").ok());
}

TEST_F(SensorStoreTest, a_file_of_a_later_version_is_left_alone) {
  const auto file = folder / "hub.sqlite";
  ASSERT_TRUE(SensorStore::open(file).ok());
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  sqlite3_exec(database, "PRAGMA user_version = 2", nullptr, nullptr, nullptr);
  sqlite3_close(database);
  const auto opened = SensorStore::open(file);
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().message.find("later roomcast"), std::string::npos);
}

TEST_F(SensorStoreTest, what_makes_no_sense_is_left_out) {
  const auto store = *SensorStore::open(folder / "hub.sqlite");
  const std::vector sensors = {sensor_at("nan", 0, std::nan("")), sensor_at("left", 1, 1),
                               sensor_at("far", 999, 1)};
  ASSERT_TRUE(store->save("lab", sensors).ok());
  const auto kept = store->load("lab");
  ASSERT_EQ(kept->size(), 2U);
  EXPECT_FALSE((*kept)[0].pose);
  EXPECT_TRUE((*kept)[1].pose);
}

}  // namespace
}  // namespace roomcast::hub
