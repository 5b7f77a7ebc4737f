// SPDX-License-Identifier: Apache-2.0
#include "bench/fanout/protocol.h"

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "roomcast/net/framed_message.h"
#include "roomcast/net/message_buffer.h"

namespace roomcast::bench {
namespace {

constexpr std::size_t kFrameBytes = 5000;
using Numbers = std::vector<std::uint32_t>;

std::string frame(std::uint32_t number) {
  auto bytes = make_frame(kFrameBytes);
  set_number(bytes, 0, number, RoomTime());
  return {bytes.begin(), bytes.end()};
}

std::string sealed(const std::string& payload) {
  const auto message = net::frame_message(net::MessageBuffer(
      std::span(reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size())));
  return {message->wire_bytes().begin(), message->wire_bytes().end()};
}

/// A WebSocket message in two fragments.
std::string in_pieces(const std::string& payload) {
  std::string whole = sealed(payload.substr(0, 3000));
  whole[0] = 0x02;
  std::string rest = sealed(payload.substr(3000));
  rest[0] = static_cast<char>(0x80);
  return whole + rest;
}

/// The numbers counted when the bytes arrive in pieces of this size.
Numbers counted(const Protocol& protocol, const std::string& bytes, std::size_t piece) {
  const auto counter = protocol.make_counter();
  Numbers numbers;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    const std::string part = bytes.substr(at, piece);
    EXPECT_TRUE(counter->take(
        std::span(reinterpret_cast<const std::uint8_t*>(part.data()), part.size()), numbers));
  }
  return numbers;
}

struct Stream {
  std::string name;
  std::function<std::unique_ptr<Protocol>()> protocol;
  std::string bytes;  // contains the frames 7 and 70000
};

std::vector<Stream> streams() {
  using namespace std::string_literals;
  const std::string a = frame(7), b = frame(70'000);
  const std::string upgraded = "HTTP/1.1 101 Switching Protocols\r\nX: y\r\n\r\n";
  const auto mqtt = [](const std::string& f) {
    const std::size_t size = f.size() + 3;
    return "\x30"s + static_cast<char>(size % 128 | 128) + static_cast<char>(size / 128) +
           "\x00\x01"s + "f" + f;
  };
  return {
      {"raw", [] { return raw_protocol(kFrameBytes); }, a + b},
      {"roomcast", [] { return roomcast_protocol(30); },
       upgraded + sealed("RC\1\2" + std::string(3000, 'c')) + sealed(a) + in_pieces(b)},
      {"nats", [] { return nats_protocol(); },
       "INFO {}\r\nMSG f 1 5000\r\n" + a + "\r\nPING\r\nMSG f 1 5000\r\n" + b + "\r\n"},
      {"redis", [] { return redis_protocol(); },
       "*3\r\n$9\r\nsubscribe\r\n$1\r\nf\r\n:1\r\n*3\r\n$7\r\nmessage\r\n$1\r\nf\r\n$5000\r\n" + a +
           "\r\n*3\r\n$7\r\nmessage\r\n$1\r\nf\r\n$5000\r\n" + b + "\r\n"},
      {"mqtt", [] { return mqtt_protocol(); },
       "\x20\x02\x00\x00\x90\x03\x00\x01\x00"s + mqtt(a) + mqtt(b)},
  };
}

TEST(Protocol, messages_are_found_however_the_bytes_are_cut) {
  for (const Stream& stream : streams()) {
    for (const std::size_t piece : {std::size_t{1}, std::size_t{977}, stream.bytes.size()}) {
      EXPECT_EQ(counted(*stream.protocol(), stream.bytes, piece), (Numbers{7, 70'000}))
          << stream.name << " in pieces of " << piece;
    }
  }
}

TEST(Protocol, heads_are_told_in_the_hubs_alone) {
  const auto hub = roomcast_protocol(10);
  EXPECT_FALSE(hub->head_of(0, 1, false).empty());
  EXPECT_GT(hub->head_of(0, 1, true).size(), hub->head_of(0, 1, false).size());
  EXPECT_NE(hub->head_of(0, 1, true), hub->head_of(0, 2, true)) << "it turns";
  EXPECT_TRUE(raw_protocol(100)->head_of(0, 1, true).empty());
}

TEST(Protocol, refusal_is_noticed) {
  const std::string refusal = "HTTP/1.1 503 Service Unavailable\r\n\r\n";
  Numbers numbers;
  EXPECT_FALSE(roomcast_protocol(30)->make_counter()->take(
      std::span(reinterpret_cast<const std::uint8_t*>(refusal.data()), refusal.size()), numbers));
}

}  // namespace
}  // namespace roomcast::bench
