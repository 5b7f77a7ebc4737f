// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/hub_choice.h"

#include <gtest/gtest.h>

namespace roomcast {
namespace {

using namespace std::chrono_literals;

HubChoice choice_of(const std::string& urls) {
  return HubChoice(*net::parse_hub_urls(urls), 1);
}

TEST(HubChoice, of_one_hub_is_that_one_after_a_pause) {
  HubChoice choice = choice_of("a");
  EXPECT_FALSE(choice.has_others());
  EXPECT_GT(choice.failed(), 100ms);
  EXPECT_EQ(choice.current().host, "a");
}

TEST(HubChoice, the_next_is_tried_at_once_and_after_all_of_them_there_is_a_pause) {
  HubChoice choice = choice_of("a,b,c");
  EXPECT_EQ(choice.failed(), 0ns);
  EXPECT_EQ(choice.current().host, "b");
  EXPECT_EQ(choice.failed(), 0ns);
  EXPECT_EQ(choice.current().host, "c");
  EXPECT_GT(choice.failed(), 100ms);
  EXPECT_EQ(choice.current().host, "a");
}

TEST(HubChoice, a_welcome_begins_anew) {
  HubChoice choice = choice_of("a,b");
  EXPECT_EQ(choice.failed(), 0ns);
  choice.welcomed();
  EXPECT_EQ(choice.current().host, "b");
  EXPECT_EQ(choice.failed(), 0ns) << "the other one is perhaps there";
}

TEST(HubChoice, learns_from_its_hub_and_stays_there) {
  HubChoice choice = choice_of("a");
  choice.learn({"wss://b:1", "no address:", "wss://c:1"});
  EXPECT_EQ(choice.current().host, "a");
  EXPECT_EQ(choice.failed(), 0ns);
  EXPECT_EQ(choice.current().host, "b");
  choice.welcomed();
  choice.learn({"wss://d:1"});  // b does not name itself
  EXPECT_EQ(choice.current().host, "b");
  EXPECT_EQ(choice.failed(), 0ns);
  EXPECT_EQ(choice.current().host, "d");
  EXPECT_EQ(choice.failed(), 0ns);
  EXPECT_EQ(choice.current().host, "a") << "what it was given is never forgotten";
}

}  // namespace
}  // namespace roomcast
