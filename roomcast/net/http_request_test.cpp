// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/http_request.h"

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

std::string token_in(const std::string& header) {
  HttpRequest request;
  request.authorization = header;
  return bearer_token(request);
}

TEST(HttpRequest, a_bearer_token_is_found_whatever_the_case) {
  EXPECT_EQ(token_in("Bearer abc.def"), "abc.def");
  EXPECT_EQ(token_in("bearer abc"), "abc");
}

TEST(HttpRequest, other_credentials_are_no_token) {
  EXPECT_EQ(token_in(""), "");
  EXPECT_EQ(token_in("Basic YTpi"), "");
  EXPECT_EQ(token_in("Bearer"), "");
}

TEST(HttpRequest, escapes_are_resolved_and_the_rest_stays) {
  EXPECT_EQ(percent_decoded("my%20lab"), "my lab");
  EXPECT_EQ(percent_decoded("caf%C3%A9"), "caf\xC3\xA9");
  EXPECT_EQ(percent_decoded("100%"), "100%");
  EXPECT_EQ(percent_decoded("%zz%4"), "%zz%4");
  EXPECT_EQ(percent_decoded("a%2Fb"), "a/b");
}

TEST(HttpRequest, a_part_of_a_query_is_read_as_browsers_do) {
  EXPECT_EQ(query_value("room=my+lab%21&mode=mesh", "room"), "my lab!");
  EXPECT_EQ(query_value("mode=mesh&room=a&room=b", "room"), "a");
  EXPECT_EQ(query_value("r%6Fom=a%2Bb", "room"), "a+b");
  EXPECT_EQ(query_value("rooms=a&room", "room"), "");
  EXPECT_EQ(query_value("&&=&room=", "room"), "");
  EXPECT_EQ(query_value("", "room"), "");
}

TEST(HttpRequest, what_is_escaped_is_what_it_was_again) {
  EXPECT_EQ(percent_encoded("my lab/\n\"1\".mcap"), "my%20lab%2F%0A%221%22.mcap");
  EXPECT_EQ(percent_decoded(percent_encoded("caf\xC3\xA9 %41")), "caf\xC3\xA9 %41");
}

}  // namespace
}  // namespace roomcast::net
