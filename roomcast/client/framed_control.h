// SPDX-License-Identifier: Apache-2.0
// Encodes and frames a control message for a connection.
#pragma once

#include <utility>

#include "roomcast/net/framed_message.h"
#include "roomcast/wire/control.h"

namespace roomcast::client {

[[nodiscard]] inline net::FramedMessagePtr framed_control(const wire::pb::Control& control) {
  net::MessageBuffer buffer;
  wire::encode_control(control, buffer.appendable());
  return net::frame_message(std::move(buffer));
}

}  // namespace roomcast::client
