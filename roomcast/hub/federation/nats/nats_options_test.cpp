// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/nats/nats_options.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub::federation {
namespace {

TEST(NatsOptions, accepts_nats_addresses) {
  EXPECT_TRUE(
      check({.servers = {"nats://a:4222", "tls://b.example.org", "nats://u:p@[::1]:4222"}}));
}

TEST(NatsOptions, an_address_has_server_and_user) {
  const auto address = parse_nats_address("tls://u:p:q@[::1]:4000");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->host, "::1");
  EXPECT_EQ(address->port, 4000);
  EXPECT_TRUE(address->is_encrypted);
  EXPECT_EQ(address->identity.user, "u");
  EXPECT_EQ(address->identity.password, "p:q");
  const auto with_token = parse_nats_address("nats://secret@b.example.org");
  ASSERT_TRUE(with_token);
  EXPECT_EQ(with_token->host, "b.example.org");
  EXPECT_EQ(with_token->port, 4222);
  EXPECT_FALSE(with_token->is_encrypted);
  EXPECT_EQ(with_token->identity.token, "secret");
}

TEST(NatsOptions, refuses_other_addresses_without_showing_a_password) {
  for (const char* server : {"", "a:4222", "http://a:4222", "nats://", "nats://a b",
                             "nats://u:secret@", "nats://a:99999", "nats://a/b", "nats://a:1#b"}) {
    const auto status = check({.servers = {"nats://a", server}});
    ASSERT_FALSE(status) << server;
    EXPECT_EQ(status.error().code, ErrorCode::kInvalidArgument);
    EXPECT_EQ(status.error().message.find("secret"), std::string::npos);
  }
  EXPECT_FALSE(check({}));
}

TEST(NatsOptions, needs_existing_files_and_a_key_for_a_certificate) {
  const auto missing = check({.servers = {"nats://a"}, .credentials_file = "/no/such/file"});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kNotFound);
  EXPECT_NE(missing.error().message.find("/no/such/file"), std::string::npos);
  EXPECT_FALSE(check({.servers = {"nats://a"}, .cert_file = "/etc/hostname"}));
}

TEST(NatsOptions, secrets_are_not_shown) {
  EXPECT_EQ(without_secret("nats://u:p@a:4222"), "nats://a:4222");
  EXPECT_EQ(without_secret("nats://a:4222"), "nats://a:4222");
}

TEST(NatsOptions, each_refusal_is_one_sentence_with_a_remedy) {
  const std::string server = "nats://u:secret@a:4222";
  const NatsOptions plain{.servers = {server}};
  NatsOptions with_file = plain;
  with_file.credentials_file = "hub.creds";
  const auto refusal = [&](const NatsOptions& options) {
    return connect_error(NatsFault::kRefused, server, options).message;
  };
  EXPECT_NE(refusal(plain).find("--nats-credentials"), std::string::npos);
  EXPECT_NE(refusal(with_file).find("hub.creds"), std::string::npos);
  for (const auto fault : {NatsFault::kNotNats, NatsFault::kRefused, NatsFault::kRejected,
                           NatsFault::kNotTrusted, NatsFault::kOffersNoTls}) {
    const Error error = connect_error(fault, server, plain);
    EXPECT_EQ(error.code, ErrorCode::kClosed);
    EXPECT_NE(error.message.find("a:4222"), std::string::npos);
    EXPECT_EQ(error.message.find("secret"), std::string::npos);
  }
  EXPECT_EQ(connect_error(NatsFault::kNoAnswer, server, plain).code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::hub::federation
