// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/pose_store.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace roomcast::hub {
namespace {

namespace fs = std::filesystem;

class PoseStoreTest : public testing::Test {
 protected:
  PoseStoreTest() {
    std::string name = (fs::temp_directory_path() / "roomcast-poses-XXXXXX").string();
    folder = ::mkdtemp(name.data());
  }
  ~PoseStoreTest() override { fs::remove_all(folder); }

  fs::path folder;
};

KnownPose pose_of(const std::string& sensor, double x) {
  return {sensor, {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 4};
}

TEST_F(PoseStoreTest, what_was_kept_is_there_after_a_restart) {
  const std::vector poses = {pose_of("left", 1.25), pose_of("right", -3)};
  ASSERT_TRUE((*PoseStore::open(folder / "poses.sqlite"))->save("lab", poses).ok());
  const auto store = *PoseStore::open(folder / "poses.sqlite");
  const auto kept = store->load("lab");
  ASSERT_TRUE(kept.ok()) << kept.error().message;
  ASSERT_EQ(kept->size(), 2U);
  EXPECT_EQ((*kept)[0].sensor, "left");
  EXPECT_EQ((*kept)[0].world_from_depth, poses[0].world_from_depth);
  EXPECT_EQ((*kept)[0].expected_error_mm, 4);
  EXPECT_TRUE(store->load("kitchen")->empty());
}

TEST_F(PoseStoreTest, a_newer_pose_takes_the_place_of_an_older_one) {
  const auto store = *PoseStore::open(folder / "poses.sqlite");
  ASSERT_TRUE(store->save("lab", std::vector{pose_of("left", 1)}).ok());
  ASSERT_TRUE(store->save("lab", std::vector{pose_of("left", 2)}).ok());
  const auto kept = store->load("lab");
  ASSERT_EQ(kept->size(), 1U);
  EXPECT_EQ((*kept)[0].world_from_depth[3], 2);
}

TEST_F(PoseStoreTest, names_are_data_and_nothing_else) {
  const std::string name = "'); DROP TABLE poses; --";
  const auto store = *PoseStore::open(folder / "poses.sqlite");
  ASSERT_TRUE(store->save(name, std::vector{pose_of(name, 1)}).ok());
  EXPECT_EQ(store->load(name)->at(0).sensor, name);
}

TEST_F(PoseStoreTest, a_file_of_something_else_is_refused) {
  std::ofstream(folder / "poses.sqlite") << std::string(5000, 'x');
  const auto opened = PoseStore::open(folder / "poses.sqlite");
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().message.find("poses.sqlite"), std::string::npos);
  EXPECT_FALSE(PoseStore::open(folder / "no" / "such" / "folder").ok());
}

TEST_F(PoseStoreTest, poses_that_make_no_sense_are_left_out) {
  const auto store = *PoseStore::open(folder / "poses.sqlite");
  ASSERT_TRUE(
      store->save("lab", std::vector{pose_of("nan", std::nan("")), pose_of("left", 1)}).ok());
  const auto kept = store->load("lab");
  ASSERT_EQ(kept->size(), 1U);
  EXPECT_EQ((*kept)[0].sensor, "left");
}

}  // namespace
}  // namespace roomcast::hub
