// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/author_tag.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

TEST(AuthorTag, is_the_same_for_a_key_in_a_room_and_differs_for_others) {
  const auto tag = author_tag_of("lab", "secret");
  EXPECT_EQ(tag, 0xa511650e4e1b113b);  // printf 'lab\0secret' | sha256sum
  EXPECT_EQ(tag, author_tag_of("lab", "secret"));
  EXPECT_NE(tag, author_tag_of("lab", "secreT"));
  EXPECT_NE(tag, author_tag_of("cellar", "secret"));
}

TEST(AuthorTag, is_zero_without_a_key) {
  EXPECT_EQ(author_tag_of("lab", ""), 0u);
}

}  // namespace
}  // namespace roomcast::hub
