// SPDX-License-Identifier: Apache-2.0
#include "roomcast/foxglove/protocol.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/net/base64.h"

namespace roomcast::foxglove {
namespace {

TEST(FoxgloveProtocol, a_data_header_is_little_endian) {
  const auto header = data_header(0x04030201, nanoseconds(0x0807060504030201));
  const std::array<std::uint8_t, 13> expected = {1, 1, 2, 3, 4, 1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(header, expected);
}

TEST(FoxgloveProtocol, reads_subscriptions) {
  const auto request = parse_request(
      R"({"op":"subscribe","subscriptions":[{"id":0,"channelId":3},{"id":4294967295,"channelId":5}]})");
  ASSERT_TRUE(request.ok()) << request.error().message;
  ASSERT_EQ(request->subscribe.size(), 2u);
  EXPECT_EQ(request->subscribe[1].id, 4294967295u);
  EXPECT_EQ(request->subscribe[1].channel, ChannelId{5});
  const auto end = parse_request(R"({"op":"unsubscribe","subscriptionIds":[0,7]})");
  ASSERT_TRUE(end.ok());
  EXPECT_EQ(end->unsubscribe, (std::vector<std::uint32_t>{0, 7}));
}

TEST(FoxgloveProtocol, refuses_what_is_no_request) {
  for (const char* text :
       {"", "[]", "{", "null", R"({"op":1})", R"({"op":"subscribe"})",
        R"({"op":"subscribe","subscriptions":{}})", R"({"op":"subscribe","subscriptions":[1]})",
        R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})",
        R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":1}]})",
        R"({"op":"subscribe","subscriptions":[{"id":1.5,"channelId":1}]})",
        R"({"op":"unsubscribe","subscriptionIds":["1"]})"}) {
    const auto request = parse_request(text);
    ASSERT_FALSE(request.ok()) << text;
    EXPECT_EQ(request.error().code, ErrorCode::kMalformed) << text;
  }
  EXPECT_FALSE(parse_request(std::string(60'000, '[')).ok());
}

TEST(FoxgloveProtocol, refuses_long_lists) {
  nlohmann::json ids = std::vector<int>(1025, 1);
  EXPECT_FALSE(
      parse_request(nlohmann::json{{"op", "unsubscribe"}, {"subscriptionIds", ids}}.dump()).ok());
}

TEST(FoxgloveProtocol, operations_of_other_servers_are_unsupported) {
  const auto request = parse_request(R"({"op":"getParameters","parameterNames":[]})");
  ASSERT_FALSE(request.ok());
  EXPECT_EQ(request.error().code, ErrorCode::kUnsupported);
}

TEST(FoxgloveProtocol, channels_are_advertised_with_their_schema) {
  const Channel channels[] = {{ChannelId{3}, "/s0/depth", recording::FoxgloveKind::kDepth}};
  const auto message = nlohmann::json::parse(advertise(channels));
  EXPECT_EQ(message["op"], "advertise");
  const auto& channel = message["channels"][0];
  EXPECT_EQ(channel["id"], 3);
  EXPECT_EQ(channel["topic"], "/s0/depth");
  EXPECT_EQ(channel["encoding"], "protobuf");
  EXPECT_EQ(channel["schemaName"], "foxglove.RawImage");
  const std::string files = foxglove_schema(recording::FoxgloveKind::kDepth).files;
  EXPECT_EQ(channel["schema"],
            net::base64({reinterpret_cast<const std::uint8_t*>(files.data()), files.size()}));
}

TEST(FoxgloveProtocol, text_that_is_no_utf8_is_replaced) {
  EXPECT_TRUE(nlohmann::json::accept(status(Level::kError, "\xff")));
  EXPECT_EQ(nlohmann::json::parse(status(Level::kWarning, "slow"))["level"], 1);
}

}  // namespace
}  // namespace roomcast::foxglove
