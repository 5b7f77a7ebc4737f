// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_frame.h"

#include <algorithm>
#include <cstring>

#include "roomcast/core/assert.h"

namespace roomcast::net {

namespace {

void put_big_endian(FrameHeader& header, std::uint64_t value, int bytes) {
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) {
    header.bytes[header.size++] = static_cast<std::uint8_t>(value >> shift);
  }
}

}  // namespace

bool may_be_sent(std::uint16_t code) {
  const bool registered = (code >= 1000 && code <= 1003) || (code >= 1007 && code <= 1014);
  const bool private_use = code >= 3000 && code <= 4999;
  return registered || private_use;
}

FrameHeader make_frame_header(Opcode opcode, std::uint64_t payload_size,
                              std::optional<MaskKey> mask) {
  FrameHeader header;
  header.bytes[header.size++] =
      static_cast<std::uint8_t>(kFinBit | static_cast<std::uint8_t>(opcode));
  const std::uint8_t mask_bit = mask ? kMaskBit : 0;
  if (payload_size <= 125) {
    header.bytes[header.size++] = static_cast<std::uint8_t>(mask_bit | payload_size);
  } else if (payload_size <= 0xFFFF) {
    header.bytes[header.size++] = mask_bit | 126;
    put_big_endian(header, payload_size, 2);
  } else {
    header.bytes[header.size++] = mask_bit | 127;
    put_big_endian(header, payload_size, 8);
  }
  if (mask) {
    for (const std::uint8_t byte : *mask) header.bytes[header.size++] = byte;
  }
  return header;
}

void mask_copy(std::span<std::uint8_t> to, std::span<const std::uint8_t> from, MaskKey key,
               std::size_t phase) {
  ROOMCAST_ASSERT(to.size() == from.size());
  std::array<std::uint8_t, 8> turned{};
  for (std::size_t i = 0; i < turned.size(); ++i) turned[i] = key[(phase + i) % 4];
  std::uint64_t word_key = 0;
  std::memcpy(&word_key, turned.data(), sizeof(word_key));

  std::size_t i = 0;
  for (; i + sizeof(word_key) <= from.size(); i += sizeof(word_key)) {
    std::uint64_t word = 0;
    std::memcpy(&word, from.data() + i, sizeof(word));
    word ^= word_key;
    std::memcpy(to.data() + i, &word, sizeof(word));
  }
  for (; i < from.size(); ++i) to[i] = from[i] ^ turned[i % 8];
}

std::string_view cut_close_reason(std::string_view reason) {
  if (reason.size() <= kMaxCloseReason) return reason;
  std::size_t end = kMaxCloseReason;
  const auto continues_character = [&](std::size_t i) {
    return (static_cast<std::uint8_t>(reason[i]) & 0xC0) == 0x80;
  };
  while (end > 0 && continues_character(end)) --end;
  return reason.substr(0, end);
}

}  // namespace roomcast::net
