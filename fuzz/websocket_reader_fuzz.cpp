// SPDX-License-Identifier: Apache-2.0
// WebSocketReader on arbitrary bytes. Byte 0 selects the role, byte 1 the message limit, byte 2 how
// the rest is split. For any split: the same events, no message above the limit, nothing after the
// end, and no more memory for incomplete messages than the limit.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "roomcast/core/assert.h"
#include "roomcast/net/utf8.h"
#include "roomcast/net/websocket_reader.h"

namespace {

using namespace roomcast::net;

std::string describe(const MessageBuffer& message) {
  return "message " + std::string(message.payload().begin(), message.payload().end());
}
std::string describe(const Ping& ping) {
  return "ping " + ping.payload;
}
std::string describe(const Pong& pong) {
  return "pong " + pong.payload;
}
std::string describe(const PeerClose& close) {
  ROOMCAST_ASSERT(close.code == close_code::kNoCode || may_be_sent(close.code));
  ROOMCAST_ASSERT(is_utf8(close.reason) && close.reason.size() <= kMaxCloseReason);
  return "close " + std::to_string(close.code) + " " + close.reason;
}
std::string describe(const Violation& violation) {
  ROOMCAST_ASSERT(may_be_sent(violation.code) && !violation.sentence.empty());
  return "violation " + std::to_string(violation.code);
}
std::string describe(NeedsMoreBytes) {
  return "";
}

bool is_end(const ReaderEvent& event) {
  return std::holds_alternative<PeerClose>(event) || std::holds_alternative<Violation>(event);
}

std::vector<std::string> read(WebSocketRole role, std::size_t limit,
                              std::span<const std::uint8_t> bytes, std::size_t chunk_size) {
  WebSocketReader reader(role, limit);
  std::vector<std::string> events;
  bool ended = false;
  while (!bytes.empty()) {
    auto chunk = bytes.first(std::min(chunk_size, bytes.size()));
    bytes = bytes.subspan(chunk.size());
    for (;;) {
      const ReaderEvent event = reader.next(chunk);
      if (std::holds_alternative<NeedsMoreBytes>(event)) break;
      ROOMCAST_ASSERT(!ended);
      ended = is_end(event);
      if (const auto* message = std::get_if<MessageBuffer>(&event)) {
        ROOMCAST_ASSERT(message->size() <= limit);
      }
      events.push_back(std::visit([](const auto& what) { return describe(what); }, event));
    }
    ROOMCAST_ASSERT(chunk.empty());
    ROOMCAST_ASSERT(reader.missing_bytes() <= std::max(limit, kMaxControlPayload));
  }
  return events;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  const auto role = (data[0] & 1) != 0 ? WebSocketRole::kServer : WebSocketRole::kClient;
  const std::size_t limit = std::size_t{data[1]} * 32;
  const std::size_t chunk_size = std::size_t{data[2]} + 1;
  const std::span bytes(data + 3, size - 3);
  const auto whole = read(role, limit, bytes, bytes.size() + 1);
  ROOMCAST_ASSERT(read(role, limit, bytes, chunk_size) == whole);
  ROOMCAST_ASSERT(read(role, limit, bytes, 1) == whole);
  return 0;
}
