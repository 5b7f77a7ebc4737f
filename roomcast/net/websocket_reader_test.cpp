// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_reader.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

using Bytes = std::vector<std::uint8_t>;
using Transcript = std::vector<std::string>;

constexpr std::size_t kLimit = 100'000;
constexpr MaskKey kMaskingKey = {0x37, 0xfa, 0x21, 0x3d};

std::string text_of(std::span<const std::uint8_t> bytes) {
  return {bytes.begin(), bytes.end()};
}

std::string describe(NeedsMoreBytes) {
  return "more";
}
std::string describe(const MessageBuffer& message) {
  return "message " + text_of(message.payload());
}
std::string describe(const Ping& ping) {
  return "ping " + ping.payload;
}
std::string describe(const Pong& pong) {
  return "pong " + pong.payload;
}
std::string describe(const PeerClose& close) {
  return "close " + std::to_string(close.code) + " " + close.reason;
}
std::string describe(const Violation& violation) {
  return "violation " + std::to_string(violation.code) + " " + violation.sentence;
}

/// All events in these bytes, without NeedsMoreBytes.
Transcript read(WebSocketReader& reader, std::span<const std::uint8_t> bytes) {
  Transcript transcript;
  for (;;) {
    const ReaderEvent event = reader.next(bytes);
    if (std::holds_alternative<NeedsMoreBytes>(event)) break;
    transcript.push_back(std::visit([](const auto& what) { return describe(what); }, event));
  }
  EXPECT_TRUE(bytes.empty());
  return transcript;
}

Transcript read_as_client(const Bytes& bytes, std::size_t limit = kLimit) {
  WebSocketReader reader(WebSocketRole::kClient, limit);
  return read(reader, bytes);
}

Transcript read_as_server(const Bytes& bytes, std::size_t limit = kLimit) {
  WebSocketReader reader(WebSocketRole::kServer, limit);
  return read(reader, bytes);
}

/// A frame with this first byte and payload; masked if from a client.
Bytes frame(std::uint8_t first, std::string_view payload, bool masked) {
  const FrameHeader header = make_frame_header(Opcode::kBinary, payload.size(),
                                               masked ? std::optional(kMaskingKey) : std::nullopt);
  Bytes bytes(header.view().begin(), header.view().end());
  bytes[0] = first;
  const std::size_t start = bytes.size();
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  if (masked) {
    const auto body = std::span(bytes).subspan(start);
    mask_copy(body, body, kMaskingKey, 0);
  }
  return bytes;
}
Bytes from_server(std::uint8_t first, std::string_view payload = "") {
  return frame(first, payload, false);
}
Bytes from_client(std::uint8_t first, std::string_view payload = "") {
  return frame(first, payload, true);
}

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string close_payload(int code, std::string_view reason = "") {
  return std::string{static_cast<char>(code >> 8), static_cast<char>(code)} + std::string(reason);
}

/// Fragments, control frames between them, every length form, and a close.
Bytes conversation(bool masked) {
  return frame(0x82, "", masked) + frame(0x02, "Hel", masked) +
         frame(0x89, "are you there", masked) + frame(0x00, "", masked) + frame(0x8A, "", masked) +
         frame(0x80, "lo", masked) + frame(0x82, std::string(126, 'm'), masked) +
         frame(0x8A, std::string(125, 'p'), masked) +
         frame(0x88, close_payload(1000, "bye"), masked);
}
Transcript conversation_transcript() {
  return {"message ",
          "ping are you there",
          "pong ",
          "message Hello",
          "message " + std::string(126, 'm'),
          "pong " + std::string(125, 'p'),
          "close 1000 bye"};
}

TEST(WebSocketReader, reads_the_examples_of_rfc_6455_section_5_7) {
  // The text examples, with the opcode of a binary message.
  EXPECT_THAT(read_as_client({0x82, 0x05, 0x48, 0x65, 0x6c, 0x6c, 0x6f}),
              ElementsAre("message Hello"));
  EXPECT_THAT(read_as_server({0x82, 0x85, 0x37, 0xfa, 0x21, 0x3d, 0x7f, 0x9f, 0x4d, 0x51, 0x58}),
              ElementsAre("message Hello"));
  EXPECT_THAT(read_as_client({0x02, 0x03, 0x48, 0x65, 0x6c, 0x80, 0x02, 0x6c, 0x6f}),
              ElementsAre("message Hello"));
  EXPECT_THAT(read_as_client({0x89, 0x05, 0x48, 0x65, 0x6c, 0x6c, 0x6f}),
              ElementsAre("ping Hello"));
  EXPECT_THAT(read_as_server({0x8a, 0x85, 0x37, 0xfa, 0x21, 0x3d, 0x7f, 0x9f, 0x4d, 0x51, 0x58}),
              ElementsAre("pong Hello"));
  const std::string long_text(256, 'x');
  EXPECT_THAT(read_as_client(Bytes{0x82, 0x7E, 0x01, 0x00} + Bytes(256, 'x')),
              ElementsAre("message " + long_text));
  EXPECT_THAT(
      read_as_client(Bytes{0x82, 0x7F, 0, 0, 0, 0, 0, 1, 0, 0} + Bytes(65536, 'x')).at(0).size(),
      8U + 65536U);
}

TEST(WebSocketReader, reads_a_conversation_in_one_piece) {
  EXPECT_EQ(read_as_server(conversation(true)), conversation_transcript());
  EXPECT_EQ(read_as_client(conversation(false)), conversation_transcript());
}

TEST(WebSocketReader, reads_the_same_however_the_bytes_are_cut) {
  for (const bool masked : {true, false}) {
    const Bytes bytes = conversation(masked);
    const auto role = masked ? WebSocketRole::kServer : WebSocketRole::kClient;
    for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
      WebSocketReader reader(role, kLimit);
      Transcript transcript = read(reader, std::span(bytes).first(cut));
      for (auto& event : read(reader, std::span(bytes).subspan(cut))) transcript.push_back(event);
      ASSERT_EQ(transcript, conversation_transcript()) << "cut at " << cut;
    }
  }
}

TEST(WebSocketReader, reads_the_same_byte_by_byte) {
  WebSocketReader reader(WebSocketRole::kServer, kLimit);
  Transcript transcript;
  for (const std::uint8_t byte : conversation(true)) {
    for (auto& event : read(reader, std::span(&byte, 1))) transcript.push_back(event);
  }
  EXPECT_EQ(transcript, conversation_transcript());
}

TEST(WebSocketReader, refuses_a_reserved_bit) {
  for (const std::uint8_t bit : {0x40, 0x20, 0x10}) {
    EXPECT_THAT(read_as_server(from_client(0x82 | bit, "x")),
                ElementsAre(StartsWith("violation 1002 A reserved bit")));
  }
}

TEST(WebSocketReader, refuses_opcodes_that_do_not_exist) {
  for (const std::uint8_t opcode : {3, 4, 5, 6, 7, 11, 12, 13, 14, 15}) {
    EXPECT_THAT(read_as_server(from_client(static_cast<std::uint8_t>(0x80 | opcode))),
                ElementsAre(StartsWith("violation 1002 There is no")));
  }
}

TEST(WebSocketReader, refuses_text_with_1003) {
  EXPECT_THAT(read_as_server(from_client(0x81, "hello")),
              ElementsAre(StartsWith("violation 1003 Text")));
}

TEST(WebSocketReader, a_server_refuses_unmasked_and_a_client_masked_frames) {
  EXPECT_THAT(read_as_server(from_server(0x82, "x")),
              ElementsAre(StartsWith("violation 1002 A client must mask")));
  EXPECT_THAT(read_as_client(from_client(0x82, "x")),
              ElementsAre(StartsWith("violation 1002 A server must not mask")));
}

TEST(WebSocketReader, refuses_a_long_or_fragmented_control_frame) {
  for (const std::uint8_t opcode : {0x8, 0x9, 0xA}) {
    EXPECT_THAT(read_as_client(
                    from_server(static_cast<std::uint8_t>(0x80 | opcode), std::string(126, 'x'))),
                ElementsAre(StartsWith("violation 1002 A WebSocket control frame holds")));
    EXPECT_THAT(read_as_client(from_server(opcode, "x")),
                ElementsAre(StartsWith("violation 1002 A WebSocket control frame must not")));
  }
}

TEST(WebSocketReader, refuses_fragments_out_of_order) {
  EXPECT_THAT(read_as_client(from_server(0x80, "x")),
              ElementsAre(StartsWith("violation 1002 A continuation came")));
  EXPECT_THAT(read_as_client(from_server(0x02, "x") + from_server(0x82, "y")),
              ElementsAre(StartsWith("violation 1002 A new WebSocket message began")));
  EXPECT_THAT(read_as_client(from_server(0x82, "x") + from_server(0x80, "y")),
              ElementsAre("message x", StartsWith("violation 1002")));
}

TEST(WebSocketReader, refuses_a_length_that_is_longer_than_it_need_be) {
  EXPECT_THAT(read_as_client({0x82, 126, 0, 125}), ElementsAre(StartsWith("violation 1002")));
  EXPECT_THAT(read_as_client({0x82, 127, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF}),
              ElementsAre(StartsWith("violation 1002")));
}

TEST(WebSocketReader, refuses_a_length_with_its_top_bit_set) {
  EXPECT_THAT(read_as_client({0x82, 127, 0x80, 0, 0, 0, 0, 0, 0, 0}),
              ElementsAre(StartsWith("violation 1002")));
}

TEST(WebSocketReader, refuses_a_message_above_the_limit_when_it_is_announced) {
  EXPECT_THAT(read_as_client(from_server(0x82, "12345"), 5), ElementsAre("message 12345"));
  const Bytes header_only = {0x82, 6};
  EXPECT_THAT(read_as_client(header_only, 5), ElementsAre(StartsWith("violation 1009")));
  EXPECT_THAT(read_as_client({0x82, 127, 0x7F, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}, 5),
              ElementsAre(StartsWith("violation 1009")));
}

TEST(WebSocketReader, counts_all_fragments_against_the_limit) {
  EXPECT_THAT(read_as_client(from_server(0x02, "123") + from_server(0x80, "45"), 5),
              ElementsAre("message 12345"));
  EXPECT_THAT(read_as_client(from_server(0x02, "123") + from_server(0x80, "456"), 5),
              ElementsAre(StartsWith("violation 1009")));
}

TEST(WebSocketReader, a_lowered_limit_holds_from_the_next_frame_on) {
  WebSocketReader reader(WebSocketRole::kClient, 10);
  const Bytes first = from_server(0x02, "12345");
  EXPECT_THAT(read(reader, first), IsEmpty());
  reader.set_max_message_bytes(3);
  EXPECT_THAT(read(reader, from_server(0x80, "")), ElementsAre(StartsWith("violation 1009")));
}

TEST(WebSocketReader, a_raised_limit_lets_more_in) {
  WebSocketReader reader(WebSocketRole::kClient, 3);
  reader.set_max_message_bytes(5);
  EXPECT_THAT(read(reader, from_server(0x82, "12345")), ElementsAre("message 12345"));
}

TEST(WebSocketReader, an_announcement_alone_costs_no_memory) {
  constexpr std::size_t kAnnounced = std::size_t{1} << 40;
  WebSocketReader reader(WebSocketRole::kClient, kAnnounced);
  EXPECT_THAT(read(reader, Bytes{0x82, 127, 0, 0, 1, 0, 0, 0, 0, 0}), IsEmpty());
  EXPECT_THAT(read(reader, Bytes(1000)), IsEmpty());  // reserving 1 TiB would have thrown
  EXPECT_EQ(reader.missing_bytes(), kAnnounced - 1000);
}

TEST(WebSocketReader, a_large_message_takes_no_more_memory_than_it_has_bytes) {
  constexpr std::size_t kSize = 1'000'000;
  WebSocketReader reader(WebSocketRole::kClient, kSize);
  Bytes bytes = from_server(0x82, std::string(kSize, 'x'));
  auto rest = std::span<const std::uint8_t>(bytes);
  for (;;) {
    auto chunk = rest.first(std::min<std::size_t>(rest.size(), 4096));
    rest = rest.subspan(chunk.size());
    ReaderEvent event = reader.next(chunk);
    if (auto* message = std::get_if<MessageBuffer>(&event)) {
      EXPECT_EQ(message->appendable().capacity(), MessageBuffer::kHeadroom + kSize);
      break;
    }
    ASSERT_FALSE(rest.empty());
  }
}

TEST(WebSocketReader, reads_every_form_of_a_close_frame) {
  EXPECT_THAT(read_as_client(from_server(0x88)), ElementsAre("close 1005 "));
  EXPECT_THAT(read_as_client(from_server(0x88, close_payload(1001))), ElementsAre("close 1001 "));
  EXPECT_THAT(read_as_client(from_server(0x88, close_payload(4000, "gr\xC3\xBC\xC3\x9F"))),
              ElementsAre("close 4000 gr\xC3\xBC\xC3\x9F"));
}

TEST(WebSocketReader, refuses_a_close_frame_that_makes_no_sense) {
  EXPECT_THAT(read_as_client(from_server(0x88, "x")), ElementsAre(StartsWith("violation 1002")));
  for (const int code : {0, 999, 1004, 1005, 1006, 1015, 5000}) {
    EXPECT_THAT(read_as_client(from_server(0x88, close_payload(code))),
                ElementsAre(StartsWith("violation 1002 The close code")));
  }
  EXPECT_THAT(read_as_client(from_server(0x88, close_payload(1000, "\xFF"))),
              ElementsAre(StartsWith("violation 1007")));
}

TEST(WebSocketReader, takes_and_forgets_everything_after_a_close_or_a_violation) {
  const Bytes closed = from_server(0x88, close_payload(1000)) + from_server(0x82, "late");
  EXPECT_THAT(read_as_client(closed), ElementsAre("close 1000 "));
  const Bytes wrong = from_server(0xC2, "x") + from_server(0x82, "late");
  EXPECT_THAT(read_as_client(wrong), ElementsAre(StartsWith("violation 1002")));
}

}  // namespace
}  // namespace roomcast::net
