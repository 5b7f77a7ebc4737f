// SPDX-License-Identifier: Apache-2.0
// FrameSet: the frames of all sensors for one instant of a room, ready to be written to any number
// of viewers. Threading: immutable once shared.
#pragma once

#include <memory>
#include <vector>

#include "roomcast/core/ids.h"
#include "roomcast/net/framed_message.h"
#include "roomcast/net/message_buffer.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::hub {

/// As it came from a sensor; wire::parse_frame has accepted it.
struct IncomingFrame {
  ConnectionId from;
  wire::FrameHeader header;
  net::MessageBuffer message;
};

struct SetFrame {
  wire::FrameHeader header;
  net::FramedMessagePtr message;  // header and payload, WebSocket header included
};

struct FrameSet {
  SetId id;
  std::vector<SetFrame>
      frames;  // in order of connection_info; of a sensor that catches up more than one
};

using FrameSetPtr = std::shared_ptr<const FrameSet>;

}  // namespace roomcast::hub
