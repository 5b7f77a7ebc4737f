// SPDX-License-Identifier: Apache-2.0
// Frames a control message for writing to connections: encoded once, shared by all receivers.
#pragma once

#include "roomcast/net/framed_message.h"
#include "roomcast/wire/control.h"

namespace roomcast::hub {

[[nodiscard]] inline net::FramedMessagePtr framed_control(const wire::pb::Control& control) {
  net::MessageBuffer buffer;
  wire::encode_control(control, buffer.appendable());
  return net::frame_message(std::move(buffer));
}

}  // namespace roomcast::hub
