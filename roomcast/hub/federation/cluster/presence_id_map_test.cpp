// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/presence_id_map.h"

#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::hub::federation {
namespace {

constexpr HubId kOne{3}, kOtherOrigin{8};

PresenceIdMap::Entries people(std::initializer_list<std::uint32_t> ids) {
  PresenceIdMap::Entries entries;
  for (const auto id : ids) entries.Add()->set_id(id);
  return entries;
}

TEST(PresenceIdMap, assigns_stable_ids) {
  PresenceIdMap hubs;
  hubs.set(kOne, people({1, 2}));
  hubs.set(kOtherOrigin, people({1}));
  const auto before = hubs.all();
  ASSERT_EQ(before.people_size(), 3);
  EXPECT_NE(before.people(0).id(), before.people(2).id());
  hubs.set(kOne, people({2}));
  const auto after = hubs.all();
  ASSERT_EQ(after.people_size(), 2);
  EXPECT_EQ(after.people(0).id(), before.people(1).id());
  hubs.set(kOne, people({1, 2}));
  EXPECT_NE(hubs.all().people(0).id(), before.people(0).id()) << "another person";
}

TEST(PresenceIdMap, renames_poses_of_people_reported_by_the_same_hub_only) {
  PresenceIdMap hubs;
  hubs.set(kOne, people({1}));
  wire::pb::ViewerPoses poses;
  poses.add_poses()->set_viewer_id(1);
  poses.add_poses()->set_viewer_id(2);
  ASSERT_EQ(hubs.renamed(kOne, poses).poses_size(), 1);
  EXPECT_EQ(hubs.renamed(kOne, poses).poses(0).viewer_id(), hubs.all().people(0).id());
  EXPECT_EQ(hubs.renamed(kOtherOrigin, poses).poses_size(), 0);
}

TEST(PresenceIdMap, limits_the_people_of_one_hub) {
  PresenceIdMap hubs;
  PresenceIdMap::Entries many;
  for (int i = 0; i <= wire::kMaxPeopleHere; ++i) many.Add()->set_id(static_cast<unsigned>(i));
  hubs.set(kOne, many);
  EXPECT_EQ(hubs.all().people_size(), wire::kMaxPeopleHere);
}

}  // namespace
}  // namespace roomcast::hub::federation
