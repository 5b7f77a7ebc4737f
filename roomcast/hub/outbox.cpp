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
  make_room();
}

void Outbox::make_room() {
  const auto is_untouched = [](const QueuedSet& queued) { return queued.next_frame == 0; };
  const auto waiting = std::ranges::find_if(sets_, is_untouched);
  if (static_cast<std::size_t>(sets_.end() - waiting) <= wire::kMaxQueuedSets) return;
  const auto nothing_builds_on = [](const QueuedSet& queued) {
    return std::ranges::all_of(queued.set->frames,
                               [](const SetFrame& frame) { return frame.header.layer > 0; });
  };
  const auto victim = std::find_if(waiting, sets_.end(), nothing_builds_on);
  sets_.erase(victim != sets_.end() ? victim : waiting);
  ++dropped_sets_;
}

net::SealedMessagePtr Outbox::next() {
  if (!control_.empty()) {
    auto message = std::move(control_.front());
    control_.erase(control_.begin());
    return message;
  }
  while (!sets_.empty()) {
    auto& [set, next_frame] = sets_.front();
    while (next_frame < set->frames.size()) {
      const SetFrame& frame = set->frames[next_frame++];
      if (may_deliver(frame.header)) return frame.message;
    }
    sets_.erase(sets_.begin());
  }
  return nullptr;
}

bool Outbox::may_deliver(const wire::FrameHeader& header) {
  Chain& chain = chain_of(header.sensor);
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
  chain_of(sensor) = {};
}

Outbox::Chain& Outbox::chain_of(SensorId sensor) {
  if (chains_.size() <= sensor.value) chains_.resize(sensor.value + 1U);
  return chains_[sensor.value];
}

std::vector<SensorId> Outbox::take_key_needs() {
  return std::exchange(key_needs_, {});
}

}  // namespace roomcast::hub
