// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/mirror/shown_presence.h"

#include <gtest/gtest.h>

namespace roomcast::hub::federation {
namespace {

TEST(ShownPresence, are_told_once_and_again_when_they_were_forgotten) {
  ShownPresence shown;
  wire::pb::PeopleHere people;
  EXPECT_FALSE(shown.news(people)) << "nobody is there, and the room knows of nobody";
  people.add_people()->set_id(7);
  const auto first = shown.news(people);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->people_here().people(0).id(), 7u);
  EXPECT_FALSE(shown.news(people));
  shown.forget();
  EXPECT_TRUE(shown.news(people));
  EXPECT_TRUE(shown.news({})) << "they are gone";
}

}  // namespace
}  // namespace roomcast::hub::federation
