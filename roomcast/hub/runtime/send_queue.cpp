// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/send_queue.h"

#include <algorithm>
#include <utility>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {

bool SendQueue::push_control(net::FramedMessagePtr message) {
  if (control_.size() >= wire::kMaxQueuedControlMessages) return false;
  control_.push_back(std::move(message));
  return true;
}

void SendQueue::push_audio(ViewerId speaker, net::FramedMessagePtr packet) {
  const auto drop_oldest = [this](auto oldest) {
    audio_.erase(oldest);
    ++dropped_audio_;
  };
  const auto waiting = std::ranges::count(audio_, speaker, &QueuedAudio::speaker);
  if (waiting >= static_cast<std::ptrdiff_t>(wire::kMaxQueuedAudioPackets)) {
    drop_oldest(std::ranges::find(audio_, speaker, &QueuedAudio::speaker));
  } else if (audio_.size() >= wire::kMaxQueuedAudioPackets * wire::kMaxSpeakersHeard) {
    drop_oldest(audio_.begin());  // other speakers were nearest before
  }
  audio_.push_back({speaker, std::move(packet)});
}

void SendQueue::push_set(FrameSetPtr set) {
  sets_.push_back({std::move(set), 0});
  drop_excess();
}

void SendQueue::drop_excess() {
  const auto waiting_sets = [this] {
    double sum = 0;
    for (const QueuedSet& queued : sets_) sum += size_in_sets(queued);
    return sum;
  };
  while (waiting_sets() > static_cast<double>(wire::kMaxQueuedSets)) {
    if (drop_upper_layers_of_one()) continue;
    sets_.erase(std::ranges::find_if(sets_, [](const auto& s) { return s.next_frame == 0; }));
    ++dropped_sets_;
  }
}

/// Drops the upper-layer frames of the oldest waiting set that has any. False: no waiting set has
/// any.
bool SendQueue::drop_upper_layers_of_one() {
  const auto victim = std::ranges::find_if(sets_, [](const QueuedSet& queued) {
    const auto& frames = queued.set->frames;
    return queued.next_frame == 0 && !queued.base_only && base_frames(*queued.set) < frames.size();
  });
  if (victim == sets_.end()) return false;
  victim->base_only = true;
  if (base_frames(*victim->set) > 0) return true;
  sets_.erase(victim);
  ++dropped_sets_;
  return true;
}

std::size_t SendQueue::base_frames(const FrameSet& set) {
  return static_cast<std::size_t>(std::ranges::count_if(
      set.frames, [](const SetFrame& frame) { return frame.header.layer == 0; }));
}

/// The size of a waiting set, in whole sets; 0 for a set that is being written.
double SendQueue::size_in_sets(const QueuedSet& queued) {
  if (queued.next_frame > 0) return 0;
  if (!queued.base_only) return 1;
  return static_cast<double>(base_frames(*queued.set)) /
         static_cast<double>(queued.set->frames.size());
}

net::FramedMessagePtr SendQueue::next() {
  if (!control_.empty()) {
    auto message = std::move(control_.front());
    control_.erase(control_.begin());
    return message;
  }
  if (!audio_.empty()) {
    auto packet = std::move(audio_.front().packet);
    audio_.erase(audio_.begin());
    return packet;
  }
  while (!sets_.empty()) {
    if (auto message = next_of(sets_.front())) return message;
    sets_.erase(sets_.begin());
  }
  return nullptr;
}

/// The next frame of a set, or its end if frames were delivered without the last one; null: it is
/// done.
net::FramedMessagePtr SendQueue::next_of(QueuedSet& queued) {
  const auto& frames = queued.set->frames;
  while (queued.next_frame < frames.size()) {
    const SetFrame& frame = frames[queued.next_frame++];
    if (!is_wanted(frame.header, queued.base_only) || !may_deliver(frame.header)) continue;
    queued.must_end = !frame.header.last;
    return frame.message;
  }
  return std::exchange(queued.must_end, false) ? queued.set->end : nullptr;
}

/// A paused sensor goes on with a key frame, which is asked for then.
void SendQueue::set_details(SensorDetails details) {
  details_ = std::move(details);
  for (std::uint16_t sensor = 0; sensor < details_.size(); ++sensor) {
    if (details_[sensor] == Detail::kPaused) forget(SensorId{sensor});
  }
}

bool SendQueue::is_wanted(const wire::FrameHeader& header, bool base_only) const {
  const Detail detail = detail_of(details_, header.sensor);
  if (detail == Detail::kPaused) return false;
  if (detail == Detail::kKeyFrames) return header.key;
  return header.layer == 0 || (!base_only && detail == Detail::kAll);
}

bool SendQueue::may_deliver(const wire::FrameHeader& header) {
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

void SendQueue::forget(SensorId sensor) {
  chain_of(sensor) = {};
}

SendQueue::Chain& SendQueue::chain_of(SensorId sensor) {
  if (chains_.size() <= sensor.value) chains_.resize(sensor.value + 1U);
  return chains_[sensor.value];
}

std::vector<SensorId> SendQueue::take_key_needs() {
  return std::exchange(key_needs_, {});
}

}  // namespace roomcast::hub
