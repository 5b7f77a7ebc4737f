// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_handshake.h"

#include <string>

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

namespace http = boost::beast::http;

constexpr std::string_view kProtocol = "roomcast.v1";
constexpr std::string_view kKey = "dGhlIHNhbXBsZSBub25jZQ==";  // RFC 6455 section 1.3

EmptyRequest good_request() {
  return make_upgrade_request("hub.example:7600", "/ws", kKey, kProtocol);
}

int refusal_of(const EmptyRequest& request) {
  const auto refusal = refuse_upgrade(request, kProtocol);
  return refusal ? refusal->status : 0;
}

TEST(WebSocketHandshake, answers_the_sample_nonce_of_rfc_6455) {
  EXPECT_EQ(accept_for(kKey), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
}

TEST(WebSocketHandshake, keys_are_16_random_bytes_in_base64) {
  EXPECT_EQ(random_key().size(), 24U);
  EXPECT_NE(random_key(), random_key());
  auto request = good_request();
  request.set(http::field::sec_websocket_key, random_key());
  EXPECT_EQ(refusal_of(request), 0);
}

TEST(WebSocketHandshake, our_client_and_our_server_agree) {
  const auto request = good_request();
  EXPECT_EQ(refusal_of(request), 0);
  const auto response = make_upgrade(request, kProtocol);
  EXPECT_EQ(response.result(), http::status::switching_protocols);
  EXPECT_EQ(fault_in_upgrade(response, kKey, kProtocol), std::nullopt);
}

TEST(WebSocketHandshake, reads_lists_as_browsers_write_them) {
  auto request = good_request();
  request.set(http::field::connection, "keep-alive, Upgrade");
  request.set(http::field::upgrade, "WebSocket");
  request.set(http::field::sec_websocket_protocol, "other, roomcast.v1");
  EXPECT_EQ(refusal_of(request), 0);
}

TEST(WebSocketHandshake, reads_a_subprotocol_list_spread_over_fields) {
  auto request = good_request();
  request.set(http::field::sec_websocket_protocol, "other");
  request.insert(http::field::sec_websocket_protocol, "roomcast.v1");
  EXPECT_EQ(refusal_of(request), 0);
}

TEST(WebSocketHandshake, refuses_requests_without_an_upgrade_with_426) {
  auto no_upgrade = good_request();
  no_upgrade.erase(http::field::upgrade);
  EXPECT_EQ(refusal_of(no_upgrade), 426);
  auto no_connection = good_request();
  no_connection.set(http::field::connection, "keep-alive");
  EXPECT_EQ(refusal_of(no_connection), 426);
  auto old_version = good_request();
  old_version.set(http::field::sec_websocket_version, "8");
  EXPECT_EQ(refusal_of(old_version), 426);
  auto old_http = good_request();
  old_http.version(10);
  EXPECT_EQ(refusal_of(old_http), 426);
  auto head = good_request();
  head.method(http::verb::head);
  EXPECT_EQ(refusal_of(head), 426);
}

TEST(WebSocketHandshake, refuses_a_key_that_is_not_16_bytes) {
  for (const char* key : {"", "short", "dGhlIHNhbXBsZSBub25jZQ=", "dGhlIHNhbXBsZSBub25jZQ===",
                          "dGhlIHNhbXBsZSBub25jZWE=", "!!!!IHNhbXBsZSBub25jZQ=="}) {
    auto request = good_request();
    request.set(http::field::sec_websocket_key, key);
    EXPECT_EQ(refusal_of(request), 400) << key;
  }
}

TEST(WebSocketHandshake, refuses_a_missing_or_other_subprotocol) {
  auto request = good_request();
  for (const char* other : {"roomcast.v2", "ROOMCAST.V1", "roomcast.v1x", ""}) {
    request.set(http::field::sec_websocket_protocol, other);
    EXPECT_EQ(refusal_of(request), 400) << other;
  }
  request.erase(http::field::sec_websocket_protocol);
  EXPECT_EQ(refusal_of(request), 400);
}

TEST(WebSocketHandshake, refuses_two_hosts_and_two_origins) {
  auto two_hosts = good_request();
  two_hosts.insert(http::field::host, "evil.example");
  EXPECT_EQ(refusal_of(two_hosts), 400);
  auto two_origins = good_request();
  two_origins.set(http::field::origin, "http://hub.example:7600");
  two_origins.insert(http::field::origin, "http://evil.example");
  EXPECT_EQ(refusal_of(two_origins), 400);
}

TEST(WebSocketHandshake, refuses_pages_of_peer_origins) {
  auto request = good_request();
  request.set(http::field::origin, "http://hub.example:7600");
  EXPECT_EQ(refusal_of(request), 0);
  for (const char* origin : {"http://evil.example", "http://hub.example:7601", "null", "",
                             "http://hub.example:7600.evil.example"}) {
    request.set(http::field::origin, origin);
    EXPECT_EQ(refusal_of(request), 403) << origin;
  }
  request.set(http::field::origin, "http://hub.example:7600");
  request.erase(http::field::host);
  EXPECT_EQ(refusal_of(request), 403);
}

TEST(WebSocketHandshake, compares_hosts_without_case_and_default_ports) {
  EXPECT_TRUE(is_same_host("http://Hub.example", "hub.EXAMPLE"));
  EXPECT_TRUE(is_same_host("http://hub.example", "hub.example:80"));
  EXPECT_TRUE(is_same_host("https://hub.example:443", "hub.example"));
  EXPECT_TRUE(is_same_host("http://[::1]:7600", "[::1]:7600"));
  EXPECT_FALSE(is_same_host("http://hub.example:443", "hub.example"));
  EXPECT_FALSE(is_same_host("hub.example", "hub.example"));
}

TEST(WebSocketHandshake, the_client_refuses_a_wrong_answer) {
  const auto request = good_request();
  auto wrong_accept = make_upgrade(request, kProtocol);
  wrong_accept.set(http::field::sec_websocket_accept, "s3pPLMBiTxaQ9kYGzzhZRbK+xOx=");
  EXPECT_TRUE(fault_in_upgrade(wrong_accept, kKey, kProtocol).has_value());
  auto no_upgrade = make_upgrade(request, kProtocol);
  no_upgrade.erase(http::field::upgrade);
  EXPECT_TRUE(fault_in_upgrade(no_upgrade, kKey, kProtocol).has_value());
  auto no_protocol = make_upgrade(request, kProtocol);
  no_protocol.erase(http::field::sec_websocket_protocol);
  EXPECT_EQ(fault_in_upgrade(no_protocol, kKey, kProtocol), "does not speak roomcast.v1");
  auto extension = make_upgrade(request, kProtocol);
  extension.set(http::field::sec_websocket_extensions, "permessage-deflate");
  EXPECT_TRUE(fault_in_upgrade(extension, kKey, kProtocol).has_value());
}

}  // namespace
}  // namespace roomcast::net
