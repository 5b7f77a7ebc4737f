// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/outbox.h"

#include <algorithm>
#include <utility>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {

bool Outbox::push_control(net::SealedMessagePtr message) {
  if (control_.size() >= wire::kMaxQueuedControlMessages) return false;
  control_.push_back(std::move(message));
  return true;
}

void Outbox::push_set(FrameSetPtr set) {
  sets_.push_back({std::move(set), 0});
  const auto untouched =
      std::find_if(sets_.begin(), sets_.end(), [](const auto& s) { return s.next_frame == 0; });
  const auto waiting = static_cast<std::size_t>(sets_.end() - untouched);
  if (waiting <= wire::kMaxQueuedSets) return;
  sets_.erase(untouched);
  ++dropped_sets_;
}

net::SealedMessagePtr Outbox::next() {
  if (!control_.empty()) {
    auto message = std::move(control_.front());
    control_.pop_front();
    return message;
  }
  while (!sets_.empty()) {
    auto& [set, next_frame] = sets_.front();
    while (next_frame < set->frames.size()) {
      const SetFrame& frame = set->frames[next_frame++];
      if (may_deliver(frame.header)) return frame.message;
    }
    sets_.pop_front();
  }
  return nullptr;
}

bool Outbox::may_deliver(const wire::FrameHeader& header) {
  Chain& chain = chains_[header.sensor];
  const bool decodable = header.key || (!chain.broken && header.base_seq == chain.base_seq);
  if (!decodable) {
    chain.broken = true;
    if (!std::exchange(chain.key_asked, true)) key_needs_.push_back(header.sensor);
    return false;
  }
  if (header.layer == 0) chain.base_seq = header.seq;
  chain.broken = false;
  chain.key_asked = false;
  return true;
}

void Outbox::forget(SensorId sensor) {
  chains_.erase(sensor);
}

std::vector<SensorId> Outbox::take_key_needs() {
  return std::exchange(key_needs_, {});
}

}  // namespace roomcast::hub
