// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/sensor_store.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub {
namespace {

/// The database and store of one run of a hub.
struct Open {
  std::unique_ptr<Database> database;
  SensorStore* operator->() { return &store; }
  SensorStore store{*database};
};

Open open_store(const TemporaryFolder& folder) {
  return {*Database::open(folder / "hub.sqlite")};
}

KnownSensor sensor_at(const std::string& name, std::uint16_t id, double x) {
  return {name, SensorId{id},
          SensorPose{.world_from_depth = {Eigen::Matrix3d::Identity(), {x, 0, 0}},
                     .source = PoseSource::kEstimated,
                     .state = PoseState::kValid,
                     .expected_error_mm = 4,
                     .depth_scale = 1.04}};
}

TEST(SensorStore, keeps_entries_across_a_restart) {
  const std::vector sensors = {sensor_at("left", 0, 1.25), sensor_at("right", 1, -3)};
  const TemporaryFolder folder;
  ASSERT_TRUE(open_store(folder)->save("lab", sensors).ok());
  auto store = open_store(folder);
  const auto kept = store->load("lab");
  ASSERT_TRUE(kept.ok()) << kept.error().message;
  ASSERT_EQ(kept->size(), 2U);
  EXPECT_EQ((*kept)[1].name, "right");
  EXPECT_EQ((*kept)[1].id, SensorId{1});
  EXPECT_EQ((*kept)[1].pose->world_from_depth.translation_m,
            sensors[1].pose->world_from_depth.translation_m);
  EXPECT_EQ((*kept)[1].pose->expected_error_mm, 4);
  EXPECT_EQ((*kept)[1].pose->depth_scale, 1.04);
  EXPECT_EQ((*kept)[1].pose->source, PoseSource::kStored);
  EXPECT_EQ((*kept)[1].pose->state, PoseState::kUnverified);
  EXPECT_TRUE(store->load("kitchen")->empty());
}

TEST(SensorStore, replaces_an_older_pose) {
  const TemporaryFolder folder;
  auto store = open_store(folder);
  ASSERT_TRUE(store->save("lab", std::vector{KnownSensor{"left", SensorId{3}}}).ok());
  EXPECT_FALSE(store->load("lab")->at(0).pose);
  ASSERT_TRUE(store->save("lab", std::vector{sensor_at("left", 3, 1)}).ok());
  ASSERT_TRUE(store->save("lab", std::vector{sensor_at("left", 3, 2)}).ok());
  const auto kept = store->load("lab");
  ASSERT_EQ(kept->size(), 1U);
  EXPECT_EQ((*kept)[0].pose->world_from_depth.translation_m.x(), 2);
}

TEST(SensorStore, an_id_belongs_to_one_sensor_of_a_room) {
  const TemporaryFolder folder;
  auto store = open_store(folder);
  ASSERT_TRUE(store->save("lab", std::vector{sensor_at("left", 0, 1)}).ok());
  ASSERT_TRUE(store->save("kitchen", std::vector{sensor_at("oven", 0, 1)}).ok());
  ASSERT_TRUE(store->save("lab", std::vector{sensor_at("door", 0, 1)}).ok());
  const auto kept = store->load("lab");
  ASSERT_EQ(kept->size(), 1U);
  EXPECT_EQ((*kept)[0].name, "door");
  EXPECT_EQ(store->load("kitchen")->at(0).name, "oven");
}

TEST(SensorStore, forgets_only_the_given_sensor) {
  const TemporaryFolder folder;
  auto store = open_store(folder);
  ASSERT_TRUE(
      store->save("lab", std::vector{sensor_at("left", 0, 1), sensor_at("right", 1, 2)}).ok());
  ASSERT_TRUE(store->save("kitchen", std::vector{sensor_at("left", 0, 1)}).ok());
  ASSERT_TRUE(store->forget("lab", "left").ok());
  EXPECT_EQ(store->load("lab")->at(0).name, "right");
  EXPECT_EQ(store->load("kitchen")->size(), 1U);
  EXPECT_EQ(store->forget("lab", "left").error().code, ErrorCode::kNotFound);
}

TEST(SensorStore, treats_names_as_data) {
  const std::string name = "'); DROP TABLE sensors; --";
  const TemporaryFolder folder;
  auto store = open_store(folder);
  ASSERT_TRUE(store->save(name, std::vector{sensor_at(name, 0, 1)}).ok());
  EXPECT_EQ(store->load(name)->at(0).name, name);
}

TEST(SensorStore, leaves_out_invalid_entries) {
  const TemporaryFolder folder;
  auto store = open_store(folder);
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
