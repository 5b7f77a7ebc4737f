// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/hub_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

HubChoice choice_of(const std::string& urls) {
  return HubChoice(*net::parse_hub_urls(urls), 1);
}
net::HubUrl hub(const std::string& url) {
  return *net::parse_hub_url(url);
}
std::vector<std::string> tried(const HubChoice& choice) {
  std::vector<std::string> hosts;
  for (const net::HubUrl& url : choice.to_try()) hosts.push_back(url.host);
  return hosts;
}

TEST(HubChoice, of_one_hub_is_that_one_after_a_pause) {
  HubChoice choice = choice_of("a");
  EXPECT_FALSE(choice.has_others());
  EXPECT_GT(choice.failed(), 100ms);
  EXPECT_THAT(tried(choice), ElementsAre("a"));
}

TEST(HubChoice, knocks_at_all_and_stays_where_it_was_answered_first) {
  HubChoice choice = choice_of("a,b,c");
  EXPECT_THAT(tried(choice), ElementsAre("a", "b", "c"));
  choice.answered(hub("b"));
  EXPECT_EQ(choice.current().host, "b");
}

TEST(HubChoice, knocks_at_the_others_at_once_when_its_hub_is_gone) {
  HubChoice choice = choice_of("a,b,c");
  choice.answered(hub("b"));
  choice.welcomed();
  EXPECT_EQ(choice.failed(), 0ns);
  EXPECT_THAT(tried(choice), ElementsAre("a", "c"));
  EXPECT_GT(choice.nobody_answered(), 100ms);
  EXPECT_THAT(tried(choice), ElementsAre("a", "b", "c")) << "perhaps it is back";
}

TEST(HubChoice, a_client_that_every_hub_refuses_waits) {
  HubChoice choice = choice_of("a,b");
  choice.answered(hub("a"));
  EXPECT_EQ(choice.failed(), 0ns);
  EXPECT_THAT(tried(choice), ElementsAre("b"));
  choice.answered(hub("b"));
  EXPECT_GT(choice.failed(), 100ms);
}

TEST(HubChoice, a_welcome_begins_anew) {
  HubChoice choice = choice_of("a,b");
  EXPECT_EQ(choice.failed(), 0ns);
  choice.answered(hub("b"));
  choice.welcomed();
  EXPECT_EQ(choice.failed(), 0ns) << "the other one is perhaps there";
}

TEST(HubChoice, learns_from_its_hub_and_stays_there) {
  HubChoice choice = choice_of("a");
  choice.learn({"wss://b:1", "no address:", "wss://c:1"});
  EXPECT_EQ(choice.current().host, "a");
  EXPECT_EQ(choice.failed(), 0ns);
  EXPECT_THAT(tried(choice), ElementsAre("b", "c"));
  choice.answered(hub("wss://b:1"));
  choice.welcomed();
  choice.learn({"wss://d:1"});  // b does not name itself
  EXPECT_EQ(choice.current().host, "b");
  EXPECT_EQ(choice.failed(), 0ns);
  EXPECT_THAT(tried(choice), ElementsAre("a", "d")) << "what it was given is never forgotten";
}

}  // namespace
}  // namespace roomcast::client
