// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_settings.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub::daemon {
namespace {

const net::ListenAddress kHere{.address = "127.0.0.1", .port = 0, .loopback = true};
const net::ListenAddress kEverywhere{.address = "0.0.0.0", .port = 0, .loopback = false};

TEST(HubSettings, only_clients_of_this_machine_need_no_token) {
  EXPECT_EQ(hub_options_of({}, kHere, false)->rooms.at(0).view, hub::AccessRule::kAnyone);
  EXPECT_EQ(hub_options_of({}, kEverywhere, true)->rooms.at(0).view, hub::AccessRule::kToken);
  hub::HubConfig open;
  open.access = "anyone";
  EXPECT_EQ(hub_options_of(open, kEverywhere, true)->rooms.at(0).view, hub::AccessRule::kAnyone);
  hub::HubConfig closed;
  closed.access = "token";
  EXPECT_EQ(hub_options_of(closed, kHere, false)->rooms.at(0).send, hub::AccessRule::kToken);
}

TEST(HubSettings, a_hub_encrypts_beyond_this_machine_by_default) {
  hub::HubConfig config;
  EXPECT_FALSE(*decide_encryption(config, kHere));
  EXPECT_TRUE(*decide_encryption(config, kEverywhere));
  EXPECT_TRUE(config.tls_self_signed);
  hub::HubConfig insecure;
  insecure.insecure = true;
  EXPECT_FALSE(*decide_encryption(insecure, kEverywhere));
  insecure.tls_self_signed = true;
  EXPECT_FALSE(decide_encryption(insecure, kEverywhere).ok());
}

TEST(HubSettings, metrics_are_public_only_without_private_rooms) {
  EXPECT_TRUE(hub_options_of({}, kHere, false)->metrics_for_anyone);
  EXPECT_FALSE(hub_options_of({}, kEverywhere, true)->metrics_for_anyone);
  hub::HubConfig with_private;
  with_private.rooms = {R"({"name": "cellar", "listed": false})"};
  EXPECT_FALSE(hub_options_of(with_private, kHere, false)->metrics_for_anyone);
}

TEST(HubSettings, refuses_a_foreign_host_name_without_a_certificate) {
  hub::HubConfig config;
  config.hosts = {"hub.example.org"};
  const auto plain = hub_options_of(config, kHere, false)->names;
  EXPECT_TRUE(plain.allows_host("hub.example.org"));
  EXPECT_FALSE(plain.allows_host("evil.example"));
  EXPECT_TRUE(hub_options_of(config, kHere, true)->names.allows_host("evil.example"));
}

TEST(HubSettings, connections_through_a_proxy_count_as_the_proxy) {
  hub::HubConfig config;
  config.proxies = {"10.0.0.1", "2001:db8::5"};
  EXPECT_EQ(hub_options_of(config, kHere, false)->limits.proxies,
            (std::vector<std::string>{"10.0.0.1", "2001:db8::/64"}));
}

TEST(HubSettings, a_file_with_a_mistake_is_named) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "roomcast.toml";
  EXPECT_EQ(find_hub_config(file).error().code, ErrorCode::kNotFound);
  std::ofstream(file) << "listen = 3\n";
  EXPECT_EQ(find_hub_config(file).error().message,
            file + ": this is no value for \"listen\" (line 1)");
  EXPECT_TRUE(find_hub_config("").ok());
}

TEST(HubSettings, other_hubs_are_named_by_address_and_a_file_with_a_token) {
  hub::HubConfig config;
  EXPECT_FALSE(upstream_of(config)->has_value());
  config.upstream_hubs = {"ws://one:7600", "wss://two:7600"};
  EXPECT_EQ((*upstream_of(config))->hubs.at(1).host, "two");
  config.upstream_token_file = "/no/such/file";
  EXPECT_EQ(upstream_of(config).error().code, ErrorCode::kNotFound);
  config.upstream_hubs = {"ftp://one"};
  EXPECT_EQ(upstream_of(config).error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace roomcast::hub::daemon
