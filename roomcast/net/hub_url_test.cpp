// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/hub_url.h"

#include <string>

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

std::string parsed(std::string_view text) {
  const auto url = parse_hub_url(text);
  return url ? to_string(*url) : "refused";
}

TEST(HubUrl, fills_in_omitted_parts) {
  EXPECT_EQ(parsed("ws://hub.example:80/ws"), "ws://hub.example:80/ws");
  EXPECT_EQ(parsed("ws://hub.example"), "ws://hub.example:7600/ws");
  EXPECT_EQ(parsed("http://hub.example:7601"), "ws://hub.example:7601/ws");
  EXPECT_EQ(parsed("http://hub.example:7601/"), "ws://hub.example:7601/ws");
  EXPECT_EQ(parsed("127.0.0.1:7600"), "ws://127.0.0.1:7600/ws");
  EXPECT_EQ(parsed("left_camera.lan."), "ws://left_camera.lan.:7600/ws");
  EXPECT_EQ(parsed("localhost"), "ws://localhost:7600/ws");
  EXPECT_EQ(parsed("WS://localhost"), "ws://localhost:7600/ws");
  EXPECT_EQ(parsed("ws://proxy.example/rooms/ws"), "ws://proxy.example:7600/rooms/ws");
}

TEST(HubUrl, reads_ipv6_addresses_in_brackets) {
  EXPECT_EQ(parsed("ws://[::1]:8000"), "ws://[::1]:8000/ws");
  EXPECT_EQ(parsed("[fe80::1%eth0]"), "ws://[fe80::1%eth0]:7600/ws");
  EXPECT_EQ(parse_hub_url("[::1]")->host, "::1");
}

TEST(HubUrl, refuses_invalid_addresses) {
  for (const std::string_view text : {"",
                                      "ws://",
                                      "ws://:7600",
                                      "host:",
                                      "host:0",
                                      "host:65536",
                                      "host:-1",
                                      "host:76x",
                                      "a b",
                                      "ws://user@host",
                                      "ftp://host",
                                      "ws://[::1",
                                      "ws://[::1]x",
                                      "[]",
                                      "::1",
                                      "../etc",
                                      "..",
                                      ".",
                                      "-1",
                                      "a-.b",
                                      "a..b",
                                      "host/p?q",
                                      "host/#x",
                                      "host/a b",
                                      "ho\nst",
                                      "host:7600\r\nX: y"}) {
    const auto url = parse_hub_url(text);
    ASSERT_FALSE(url.ok()) << text;
    EXPECT_EQ(url.error().code, ErrorCode::kInvalidArgument) << text;
  }
}

TEST(HubUrl, refuses_overlong_parts) {
  EXPECT_FALSE(parse_hub_url(std::string(254, 'a')).ok());
  EXPECT_FALSE(parse_hub_url("host/" + std::string(2000, 'a')).ok());
}

TEST(HubUrl, knows_where_there_is_encryption) {
  EXPECT_EQ(parsed("wss://hub.example"), "wss://hub.example:443/ws");
  EXPECT_EQ(parsed("https://hub.example:443/"), "wss://hub.example:443/ws");
  EXPECT_FALSE(parse_hub_url("hub.example")->tls);
}

TEST(HubUrl, pins_a_certificate_by_its_fingerprint) {
  const std::string pin = "#sha256=" + std::string(64, 'a');
  EXPECT_EQ(parsed("wss://hub.example:1/" + pin), "wss://hub.example:1/ws" + pin);
  ASSERT_TRUE(parse_hub_url("https://hub.example" + pin)->pinned);
  EXPECT_EQ(parse_hub_url("https://hub.example" + pin)->pinned->front(), 0xAA);
  for (const std::string& text :
       {"ws://hub.example" + pin, std::string("wss://hub.example#sha256=aa"),
        "wss://hub.example#md5=" + std::string(64, 'a')}) {
    const auto url = parse_hub_url(text);
    ASSERT_FALSE(url.ok()) << text;
    EXPECT_NE(url.error().message.find("fingerprint"), std::string::npos);
  }
}

}  // namespace
}  // namespace roomcast::net
