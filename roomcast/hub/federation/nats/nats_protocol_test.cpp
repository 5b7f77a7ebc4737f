// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/nats/nats_protocol.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::hub::federation {
namespace {

std::span<const std::uint8_t> bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string text(std::span<const std::uint8_t> bytes) {
  return {bytes.begin(), bytes.end()};
}

template <class Event>
bool is_first(std::string_view line) {
  auto rest = bytes(line);
  return std::holds_alternative<Event>(next_nats_event(rest));
}

TEST(NatsProtocol, reads_messages_one_by_one) {
  auto rest = bytes("MSG a.b 7 5\r\nhello\r\nMSG c 18446744073709551615 me 2\r\n\r\n\r\nPI");
  const auto first = std::get<NatsMessage>(next_nats_event(rest));
  EXPECT_EQ(first.subject, "a.b");
  EXPECT_EQ(first.subscription, 7u);
  EXPECT_EQ(text(first.bytes), "hello");
  const auto second = std::get<NatsMessage>(next_nats_event(rest));
  EXPECT_EQ(second.subject, "c");
  EXPECT_EQ(second.subscription, 18446744073709551615u);
  EXPECT_EQ(text(second.bytes), "\r\n") << "bytes of any value";
  EXPECT_TRUE(std::holds_alternative<NatsNeedsMore>(next_nats_event(rest)));
  EXPECT_EQ(text(rest), "PI");
}

TEST(NatsProtocol, waits_for_the_rest_of_a_message) {
  const std::string whole = "MSG a.b 7 5\r\nhello\r\n";
  for (std::size_t size = 0; size < whole.size(); ++size) {
    auto rest = bytes(std::string_view(whole).substr(0, size));
    EXPECT_TRUE(std::holds_alternative<NatsNeedsMore>(next_nats_event(rest))) << size;
    EXPECT_EQ(rest.size(), size);
  }
}

TEST(NatsProtocol, other_server_messages_are_one_line) {
  EXPECT_TRUE(is_first<NatsPing>("PING\r\n"));
  EXPECT_TRUE(is_first<NatsPong>("pong\r\n")) << "in any case, as the protocol has it";
  EXPECT_TRUE(is_first<NatsOk>("+OK\r\n"));
  auto rest = bytes("-ERR 'Authorization Violation'\r\nINFO {\"a\": 1} \r\n");
  EXPECT_EQ(std::get<NatsServerError>(next_nats_event(rest)).text, "Authorization Violation");
  EXPECT_EQ(std::get<NatsInfo>(next_nats_event(rest)).json, "{\"a\": 1} ");
  EXPECT_TRUE(rest.empty());
}

TEST(NatsProtocol, an_unknown_line_is_a_violation) {
  for (const char* line :
       {"\r\n", "HTTP/1.1 400 Bad Request\r\n", "MSG\r\n", "MSG a 1\r\n", "MSG a b 1\r\n",
        "MSG a 1 -1\r\n", "MSG a 1 5x\r\n", "MSG a 1 b 5 6\r\n", "MSG a 1 99999999999999999999\r\n",
        "MSG a 1 5\r\nhello, you\r\n", "HMSG a 1 12 17\r\nNATS/1.0\r\n\r\nhello\r\n"}) {
    EXPECT_TRUE(is_first<NatsViolation>(line)) << line;
  }
}

TEST(NatsProtocol, refuses_a_long_message_before_it_is_complete) {
  const auto line = "MSG a 1 " + std::to_string(kMaxNatsMessageBytes + 1) + "\r\n";
  EXPECT_TRUE(is_first<NatsViolation>(line));
  EXPECT_TRUE(is_first<NatsNeedsMore>(std::string(kMaxNatsLineBytes - 1, 'x')));
  EXPECT_TRUE(is_first<NatsViolation>(std::string(kMaxNatsLineBytes, 'x')));
}

TEST(NatsProtocol, reads_the_info_of_a_server) {
  const auto info = read_server_info(
      R"({"max_payload": 2000000, "tls_required": true, "nonce": "abc", "headers": true})");
  ASSERT_TRUE(info);
  EXPECT_EQ(info->max_message_bytes, 2'000'000u);
  EXPECT_TRUE(info->demands_tls && info->offers_tls);
  EXPECT_EQ(info->nonce, "abc");
  const auto odd = read_server_info(
      R"({"max_payload": -1, "tls_required": "yes", "nonce": 7, "tls_available": true})");
  ASSERT_TRUE(odd);
  EXPECT_EQ(odd->max_message_bytes, NatsServerInfo{}.max_message_bytes);
  EXPECT_TRUE(odd->offers_tls && !odd->demands_tls && odd->nonce.empty());
  EXPECT_EQ(read_server_info(R"({"max_payload": 1e3})")->max_message_bytes, 1u << 20);
  EXPECT_EQ(read_server_info(R"({"max_payload": 18446744073709551615})")->max_message_bytes,
            kMaxNatsMessageBytes);
  EXPECT_FALSE(read_server_info("[]") || read_server_info("{") || read_server_info(""));
}

TEST(NatsProtocol, connect_message_has_only_the_given_credentials) {
  const std::string line = connect_line({.user = "u", .password = "\"\xff"}, true);
  ASSERT_TRUE(line.starts_with("CONNECT {") && line.ends_with("}\r\n"));
  const auto identity = nlohmann::json::parse(line.substr(8));
  EXPECT_EQ(identity["user"], "u");
  EXPECT_TRUE(identity["tls_required"].get<bool>());
  EXPECT_FALSE(identity["echo"].get<bool>() || identity["headers"].get<bool>());
  EXPECT_FALSE(identity.contains("auth_token") || identity.contains("jwt") ||
               identity.contains("sig"));
}

TEST(NatsProtocol, writes_lines_of_the_protocol) {
  EXPECT_EQ(publish_line("a.b", 12), "PUB a.b 12\r\n");
  EXPECT_EQ(subscribe_line("a.*", 3), "SUB a.* 3\r\n");
  EXPECT_EQ(unsubscribe_line(3), "UNSUB 3\r\n");
}

}  // namespace
}  // namespace roomcast::hub::federation
