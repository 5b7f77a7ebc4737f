// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/send_queue.h"

#include <algorithm>
#include <functional>
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
  sets_.push_back({set, 0});
  drop_excess();
  if (allows_small_) follow_line(*set);
}

/// Chooses renditions anew where the line takes less than is offered, or takes more.
void SendQueue::follow_line(const FrameSet& offered) {
  for (const SetFrame& frame : offered.frames) chain_of(frame.header.sensor).is_known = true;
  const auto known = std::ranges::count_if(chains_, &Chain::is_known);
  const bool has_frames = std::ranges::any_of(
      offered.frames, [this](const SetFrame& frame) { return may_be_sent(frame.header, {}); });
  if (renditions_.offered(static_cast<std::size_t>(known), has_frames)) choose_renditions();
  if (!small_needs_.held_back.empty()) refresh_held_back();
}

/// Asks for a key frame of the next sensor that is held back, if nothing else waits for the line.
void SendQueue::refresh_held_back() {
  if (++sets_since_held_key_ < kSetsPerHeldKey || sets_.size() > 1) return;
  sets_since_held_key_ = 0;
  const auto& held_back = small_needs_.held_back;
  small_needs_.keys.push_back(held_back[next_held_back_++ % held_back.size()]);
}

/// Sensors of which the viewer needs layer 0 only come small before the others, and later ones
/// before those that came first. The last of them are held back.
void SendQueue::choose_renditions() {
  std::vector<SensorId> by_importance;
  for (std::uint16_t id = 0; id < chains_.size(); ++id) {
    if (chains_[id].is_known) by_importance.push_back(SensorId{id});
  }
  std::ranges::stable_sort(by_importance, std::greater(),
                           [this](SensorId sensor) { return detail_of(details_, sensor); });
  const std::size_t whole =
      by_importance.size() - std::min(by_importance.size(), renditions_.small_sensors());
  small_needs_.wanted.assign(by_importance.begin() + static_cast<std::ptrdiff_t>(whole),
                             by_importance.end());
  const std::size_t coming =
      by_importance.size() - std::min(by_importance.size(), renditions_.held_back());
  small_needs_.held_back.assign(by_importance.begin() + static_cast<std::ptrdiff_t>(coming),
                                by_importance.end());
  const auto is_among = [](const std::vector<SensorId>& sensors, std::uint16_t id) {
    return std::ranges::find(sensors, SensorId{id}) != sensors.end();
  };
  for (std::uint16_t id = 0; id < chains_.size(); ++id) {
    const bool wants_small = is_among(small_needs_.wanted, id);
    if (std::exchange(chains_[id].wants_small, wants_small) != wants_small)
      chains_[id].key_asked = false;
    chains_[id].is_held_back = is_among(small_needs_.held_back, id);
  }
  small_changed_ = true;
}

void SendQueue::drop_excess() {
  const auto waiting_sets = [this] {
    double sum = 0;
    for (const QueuedSet& queued : sets_) sum += size_in_sets(queued);
    return sum;
  };
  for (double waiting = waiting_sets(); waiting > static_cast<double>(wire::kMaxQueuedSets);
       waiting = waiting_sets()) {
    if (drop_upper_layers_of_one() || drop_superseded()) continue;
    const auto oldest = std::ranges::find(sets_, std::size_t{0}, &QueuedSet::next_frame);
    if (waiting <= static_cast<double>(kMaxQueuedBaseSets) && !is_superseded(*oldest)) return;
    count_dropped(*oldest);
    miss_keys(*oldest->set);
    sets_.erase(oldest);
  }
}

/// A key frame that was asked for may be among what was dropped: the next frame asks again.
void SendQueue::miss_keys(const FrameSet& dropped) {
  for (const SetFrame& frame : dropped.frames) {
    if (frame.header.key) chain_of(frame.header.sensor).key_asked = false;
  }
}

void SendQueue::count_dropped(const QueuedSet& queued) {
  renditions_.dropped(size_in_sets(queued));
  ++dropped_sets_;
}

/// Drops the waiting sets that would not be sent, and those that key frames behind them replace and
/// that have no key frames themselves. False: there are none.
bool SendQueue::drop_superseded() {
  bool has_dropped = false;
  for (std::size_t i = sets_.size(); i-- > 0;) {
    const QueuedSet& queued = sets_[i];
    const auto is_sent = [&](const SetFrame& frame) { return may_be_sent(frame.header, queued); };
    const auto is_sent_key = [&](const SetFrame& frame) {
      return frame.header.key && is_sent(frame);
    };
    const auto& frames = queued.set->frames;
    if (queued.next_frame > 0 || !is_superseded(queued) || std::ranges::any_of(frames, is_sent_key))
      continue;
    if (std::ranges::any_of(frames, is_sent)) count_dropped(queued);
    sets_.erase(sets_.begin() + static_cast<std::ptrdiff_t>(i));
    has_dropped = true;
  }
  return has_dropped;
}

/// Key frames behind it replace all that would be sent of it.
bool SendQueue::is_superseded(const QueuedSet& queued) const {
  const auto has_key_behind = [&](const SetFrame& frame) {
    return std::any_of(&queued + 1, sets_.data() + sets_.size(), [&](const QueuedSet& later) {
      return std::ranges::any_of(later.set->frames, [&](const SetFrame& other) {
        return other.header.key && other.header.sensor == frame.header.sensor &&
               other.header.small == frame.header.small;
      });
    });
  };
  return std::ranges::all_of(queued.set->frames, [&](const SetFrame& frame) {
    return !may_be_sent(frame.header, queued) || has_key_behind(frame);
  });
}

/// False: the receiver does not need it, or gets the other rendition.
bool SendQueue::may_be_sent(const wire::FrameHeader& header, const QueuedSet& queued) const {
  if (!is_wanted(header, queued.base_only)) return false;
  const std::size_t sensor = header.sensor.value;
  if (sensor >= chains_.size()) return !header.small;
  const Chain& chain = chains_[sensor];
  return header.small == chain.is_small || header.small == chain.wants_small;
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
  renditions_.dropped(1 - size_in_sets(*victim));
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

/// A paused sensor resumes with a key frame, which the room requests then. The renditions are
/// chosen anew, because the viewer may need other sensors most.
void SendQueue::set_details(SensorDetails details) {
  details_ = std::move(details);
  if (renditions_.small_sensors() > 0) choose_renditions();
  for (std::uint16_t sensor = 0; sensor < details_.size(); ++sensor) {
    if (details_[sensor] == Detail::kPaused) forget(SensorId{sensor});
  }
}

bool SendQueue::is_wanted(const wire::FrameHeader& header, bool base_only) const {
  const Detail detail = detail_of(details_, header.sensor);
  if (detail == Detail::kPaused) return false;
  if (detail == Detail::kKeyFrames || is_held_back(header.sensor)) return header.key;
  return header.layer == 0 || (!base_only && detail == Detail::kAll);
}

bool SendQueue::may_deliver(const wire::FrameHeader& header) {
  Chain& chain = chain_of(header.sensor);
  chain.has_small = chain.has_small || header.small;
  if (header.small != chain.is_small) {
    if (header.small != chain.wants_small) return false;
    if (!header.key) {
      ask_for_key(chain, header);
      return false;
    }
    chain.is_small = header.small;
  }
  const bool decodable = header.key || (!chain.broken && header.base_seq == chain.base_seq);
  if (!decodable) {
    chain.broken = true;
    if (!is_about_to_switch(chain)) ask_for_key(chain, header);
    return false;
  }
  if (header.layer == 0) chain.base_seq = header.seq;
  chain.broken = false;
  if (chain.is_small == chain.wants_small) chain.key_asked = false;
  return true;
}

/// To a rendition that comes.
bool SendQueue::is_about_to_switch(const Chain& chain) {
  return chain.wants_small != chain.is_small && (chain.is_small || chain.has_small);
}

/// For a key frame of this frame's rendition, once per gap.
void SendQueue::ask_for_key(Chain& chain, const wire::FrameHeader& header) {
  if (std::exchange(chain.key_asked, true)) return;
  (header.small ? small_needs_.keys : key_needs_).push_back(header.sensor);
}

/// What is wanted of it stays.
void SendQueue::forget(SensorId sensor) {
  Chain& chain = chain_of(sensor);
  chain = {.wants_small = chain.wants_small,
           .is_known = chain.is_known,
           .is_held_back = chain.is_held_back};
}

bool SendQueue::is_held_back(SensorId sensor) const {
  return sensor.value < chains_.size() && chains_[sensor.value].is_held_back;
}

SendQueue::Chain& SendQueue::chain_of(SensorId sensor) {
  if (chains_.size() <= sensor.value) chains_.resize(sensor.value + 1U);
  return chains_[sensor.value];
}

std::vector<SensorId> SendQueue::take_key_needs() {
  return std::exchange(key_needs_, {});
}

std::optional<SmallNeeds> SendQueue::take_small_needs() {
  if (!std::exchange(small_changed_, false) && small_needs_.keys.empty()) return std::nullopt;
  SmallNeeds needs = small_needs_;
  small_needs_.keys.clear();
  return needs;
}

}  // namespace roomcast::hub
