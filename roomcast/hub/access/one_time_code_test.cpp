// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/one_time_code.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

TEST(OneTimeCode, no_two_are_the_same) {
  EXPECT_NE(make_one_time_code(), make_one_time_code());
  EXPECT_NE(make_token_id(), make_token_id());
}

TEST(OneTimeCode, is_read_as_people_type_it) {
  const auto digest = digest_of_code("7K1M-90XA-0C4T-VW3H");
  ASSERT_TRUE(digest);
  EXPECT_EQ(digest_of_code("7k1m90xa0c4tvw3h"), digest);
  EXPECT_EQ(digest_of_code("7KiM 9oXA OC4T-VW3H"), digest);
  EXPECT_EQ(digest_of_code("7KLM-90XA-0C4T-VW3H"), digest);
  EXPECT_NE(digest_of_code("7K1M-90XA-0C4T-VW3J"), digest);
}

TEST(OneTimeCode, every_new_code_is_valid) {
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(digest_of_code(make_one_time_code()));
}

TEST(OneTimeCode, an_invalid_code_has_no_digest) {
  for (const char* text : {"", "7K1M", "7K1M-90XA-0C4T-VW3H-0", "7K1M-90XA-0C4T-VW3U", "....",
                           "7K1M-90XA-0C4T-VW\xC3H"}) {
    EXPECT_FALSE(digest_of_code(text)) << text;
  }
}

}  // namespace
}  // namespace roomcast::hub
