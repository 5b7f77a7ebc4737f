// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/hub_flags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::cli {
namespace {

using testing::ElementsAre;

hub::HubConfig told(const std::string& line, hub::HubConfig config = {}) {
  CLI::App command;
  HubFlags flags;
  add_hub_flags(command, flags);
  command.parse(line);
  return with_flags(std::move(config), flags);
}

hub::HubConfig file() {
  hub::HubConfig config;
  config.listen = "0.0.0.0:1";
  config.nats_servers = {"nats://a:1"};
  return config;
}

TEST(HubFlags, omitted_flags_keep_the_settings_of_the_file) {
  const hub::HubConfig config = told("", file());
  EXPECT_EQ(config.listen, "0.0.0.0:1");
  EXPECT_THAT(config.nats_servers, ElementsAre("nats://a:1"));
}

TEST(HubFlags, flags_override_the_file) {
  const hub::HubConfig config =
      told("--listen 127.0.0.1:2 --nats nats://b:1,nats://c:1 --public-url wss://d:1", file());
  EXPECT_EQ(config.listen, "127.0.0.1:2");
  EXPECT_THAT(config.nats_servers, ElementsAre("nats://b:1", "nats://c:1"));
  EXPECT_EQ(config.public_url, "wss://d:1");
}

TEST(HubFlags, a_hub_that_relays_leaves_placing_to_the_other) {
  EXPECT_TRUE(told("").align);
  EXPECT_FALSE(told("--no-align").align);
  EXPECT_FALSE(told("--no-model").model);
  EXPECT_FALSE(told("--upstream ws://a").align);
}

TEST(HubFlags, invalid_values_are_refused) {
  EXPECT_THROW(told("--threads 0"), CLI::ParseError);
  EXPECT_THROW(told("--access nobody"), CLI::ParseError);
}

}  // namespace
}  // namespace roomcast::cli
