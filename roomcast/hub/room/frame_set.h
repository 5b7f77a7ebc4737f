// SPDX-License-Identifier: Apache-2.0
// FrameSet: the frames of all sensors of a room for one instant, ready to be written to any number
// of viewers. Threading: immutable once shared.
#pragma once

#include <memory>
#include <vector>

#include "roomcast/core/ids.h"
#include "roomcast/net/framed_message.h"
#include "roomcast/net/message_buffer.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::hub {

/// A frame as a sensor sent it, after wire::parse_frame accepted it.
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
  std::vector<SetFrame> frames;  // in order of arrival; several of a sensor that catches up
  /// A SetEnd, for viewers that do not get the last frame. Null if there is one frame only.
  net::FramedMessagePtr end = nullptr;
};

using FrameSetPtr = std::shared_ptr<const FrameSet>;

}  // namespace roomcast::hub
