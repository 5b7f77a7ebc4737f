// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cluster/nats_options.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::cluster {
namespace {

TEST(NatsOptions, addresses_of_nats_are_taken) {
  EXPECT_TRUE(
      check({.servers = {"nats://a:4222", "tls://b.example.org", "nats://u:p@[::1]:4222"}}));
}

TEST(NatsOptions, what_is_no_address_is_refused_without_telling_a_password) {
  for (const char* server :
       {"", "a:4222", "http://a:4222", "nats://", "nats://a b", "nats://u:secret@"}) {
    const auto status = check({.servers = {"nats://a", server}});
    ASSERT_FALSE(status) << server;
    EXPECT_EQ(status.error().code, ErrorCode::kInvalidArgument);
    EXPECT_EQ(status.error().message.find("secret"), std::string::npos);
  }
  EXPECT_FALSE(check({}));
}

TEST(NatsOptions, files_must_be_there_and_a_certificate_has_a_key) {
  const auto missing = check({.servers = {"nats://a"}, .credentials_file = "/no/such/file"});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kNotFound);
  EXPECT_NE(missing.error().message.find("/no/such/file"), std::string::npos);
  EXPECT_FALSE(check({.servers = {"nats://a"}, .cert_file = "/etc/hostname"}));
}

TEST(NatsOptions, files_that_hold_something_else_are_named) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "file.pem").string();
  std::ofstream(file) << "this is no certificate\n";
  const auto ca = libnats_options({.servers = {"nats://a"}, .ca_file = file});
  ASSERT_FALSE(ca);
  EXPECT_NE(ca.error().message.find(file), std::string::npos);
  const auto own = libnats_options({.servers = {"nats://a"}, .cert_file = file, .key_file = file});
  ASSERT_FALSE(own);
  EXPECT_NE(own.error().message.find(file), std::string::npos);
}

TEST(NatsOptions, secrets_are_not_shown) {
  EXPECT_EQ(without_secret("nats://u:p@a:4222"), "nats://a:4222");
  EXPECT_EQ(without_secret("nats://a:4222"), "nats://a:4222");
}

TEST(NatsOptions, each_refusal_is_one_sentence_that_says_what_to_do) {
  const NatsOptions plain{.servers = {"nats://u:secret@a:4222"}};
  NatsOptions with_file = plain;
  with_file.credentials_file = "hub.creds";
  EXPECT_NE(connect_error(NATS_CONNECTION_AUTH_FAILED, plain).message.find("--nats-credentials"),
            std::string::npos);
  EXPECT_NE(connect_error(NATS_CONNECTION_AUTH_FAILED, with_file).message.find("hub.creds"),
            std::string::npos);
  for (const natsStatus status : {NATS_CONNECTION_AUTH_FAILED, NATS_SSL_ERROR, NATS_ERR,
                                  NATS_SECURE_CONNECTION_REQUIRED, NATS_SECURE_CONNECTION_WANTED}) {
    const Error error = connect_error(status, plain);
    EXPECT_EQ(error.code, ErrorCode::kClosed);
    EXPECT_NE(error.message.find("nats://a:4222"), std::string::npos);
    EXPECT_EQ(error.message.find("secret"), std::string::npos);
  }
  EXPECT_EQ(connect_error(NATS_NO_SERVER, plain).code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::cluster
