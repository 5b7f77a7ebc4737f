// SPDX-License-Identifier: Apache-2.0
// Frame sets for tests of a SendQueue.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "roomcast/hub/runtime/send_queue.h"

namespace roomcast::hub {

inline constexpr SensorId kSensor{0}, kOtherSensor{1};

inline net::FramedMessagePtr some_message() {
  return net::frame_message(net::MessageBuffer(std::vector<std::uint8_t>{1, 2, 3}));
}

struct FrameSpec {
  SensorId sensor;
  std::uint32_t seq;
  std::uint32_t base_seq;
  std::uint8_t layer = 0;
  bool small = false;
};

inline FrameSetPtr frame_set_of(std::vector<FrameSpec> specs, net::FramedMessagePtr end = nullptr) {
  auto set = std::make_shared<FrameSet>();
  set->end = std::move(end);
  for (const auto& spec : specs) {
    wire::FrameHeader header{.key = spec.seq == spec.base_seq,
                             .small = spec.small,
                             .sensor = spec.sensor,
                             .layer = spec.layer,
                             .seq = spec.seq,
                             .base_seq = spec.base_seq};
    header.last = &spec == &specs.back();
    set->frames.push_back({header, some_message()});
  }
  return set;
}

inline int drain(SendQueue& send_queue) {
  int messages = 0;
  while (send_queue.next() != nullptr) ++messages;
  return messages;
}

}  // namespace roomcast::hub
