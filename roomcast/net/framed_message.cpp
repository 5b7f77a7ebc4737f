// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/framed_message.h"

#include <algorithm>

#include "roomcast/core/assert.h"

namespace roomcast::net {

namespace {}  // namespace

FramedMessagePtr frame_message(MessageBuffer&& message, Opcode opcode,
                               std::optional<MaskKey> mask) {
  ROOMCAST_ASSERT(!is_control(opcode) || message.size() <= kMaxControlPayload);
  message.reserve(0);  // allocates the headroom of an empty buffer
  const auto payload = message.payload();
  if (mask) mask_copy(payload, payload, *mask, 0);
  const FrameHeader header = make_frame_header(opcode, payload.size(), mask);
  const std::size_t start = MessageBuffer::kHeadroom - header.size;
  auto storage = std::move(message).release();
  std::ranges::copy(header.view(), storage.begin() + static_cast<std::ptrdiff_t>(start));
  return std::make_shared<const FramedMessage>(FramedMessage::Private{}, std::move(storage), start);
}

FramedMessagePtr frame_masked_copy(const FramedMessage& message, MaskKey mask) {
  return frame_message(MessageBuffer(message.payload()), Opcode::kBinary, mask);
}

}  // namespace roomcast::net
