// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/connection.h"

#include <algorithm>
#include <utility>

#include "roomcast/hub/room/framed_control.h"
#include "roomcast/hub/runtime/shard.h"

namespace roomcast::hub {

void ReceiversByShard::add(Shard& shard, ConnectionId session) {
  auto receivers = std::ranges::find(by_shard_, &shard, &Receivers::shard);
  if (receivers == by_shard_.end()) receivers = by_shard_.insert(receivers, {&shard, {}});
  receivers->sessions.push_back(session);
}

void ControlFanOut::send() {
  if (receivers_.empty()) return;
  const auto framed = framed_control(message_);
  for (auto& [shard, sessions] : receivers_.take()) {
    shard->send_control(std::move(sessions), framed);
  }
}

void AudioFanOut::send() {
  for (auto& [shard, sessions] : receivers_.take()) {
    shard->send_audio(std::move(sessions), speaker_, packet_);
  }
}

void Connection::send(const wire::pb::Control& message) {
  ControlFanOut alone(message);
  deliver(alone);
  alone.send();
}

}  // namespace roomcast::hub
