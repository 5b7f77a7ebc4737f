// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/voices/voice_listener.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace roomcast::client {

VoiceListener::Speaker& VoiceListener::speaker(ViewerId id) {
  if (!speakers_.contains(id) && speakers_.size() == kMaxSpeakers) {
    speakers_.erase(std::ranges::min_element(speakers_, {},
                                             [](const auto& known) { return known.second.used; }));
  }
  Speaker& speaker = speakers_[id];
  speaker.used = ++uses_;
  return speaker;
}

void VoiceListener::take(HeardPacket packet) {
  Speaker& from = speaker(packet.speaker);
  const std::uint32_t lost = from.next_seq ? packet.seq - *from.next_seq : 0;
  if (lost > kMaxConcealed) from.decoder.restart();
  for (std::uint32_t i = lost > kMaxConcealed ? 0 : lost; i > 0; --i) {
    Heard& concealed = heard_.emplace_back();
    concealed.packet.speaker = packet.speaker;
    concealed.packet.seq = packet.seq - i;
    concealed.packet.capture_time = packet.capture_time - i * std::chrono::milliseconds(20);
    from.decoder.conceal(concealed.samples);
  }
  Heard& heard = heard_.emplace_back();
  from.decoder.decode(packet.opus, heard.samples);
  from.next_seq = packet.seq + 1;
  if (packet.ends) from.decoder.restart();
  heard.packet = std::move(packet);
}

std::optional<VoiceListener::Heard> VoiceListener::next() {
  if (heard_.empty()) return std::nullopt;
  Heard heard = std::move(heard_.front());
  heard_.pop_front();
  return heard;
}

}  // namespace roomcast::client
