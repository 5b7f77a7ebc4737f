// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/mirror/shown_presence.h"

#include <gtest/gtest.h>

namespace roomcast::hub::federation {
namespace {

TEST(ShownPresence, are_reported_once_and_again_after_forget) {
  ShownPresence shown;
  wire::pb::PeopleHere people;
  EXPECT_FALSE(shown.update(people)) << "there are no people, and the room has none";
  people.add_people()->set_id(7);
  const auto first = shown.update(people);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->people_here().people(0).id(), 7u);
  EXPECT_FALSE(shown.update(people));
  shown.forget();
  EXPECT_TRUE(shown.update(people));
  EXPECT_TRUE(shown.update({})) << "they have left";
}

}  // namespace
}  // namespace roomcast::hub::federation
