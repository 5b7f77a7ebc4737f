// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/voice/room_mix.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "roomcast/client/room/speaker.h"

namespace roomcast::viewer {
namespace {

/// Several loud voices are bent, not cut off, as in exported sound.
float within_scale(float value) {
  constexpr float kStraightUntil = 0.8F, kRest = 1 - kStraightUntil;
  const float loudness = std::abs(value);
  if (loudness <= kStraightUntil) return value;
  return std::copysign(kStraightUntil + kRest * std::tanh((loudness - kStraightUntil) / kRest),
                       value);
}

}  // namespace

void RoomMix::take(client::HeardPacket packet, HostTime now) {
  const auto known = speakers_.find(packet.speaker);
  if (known == speakers_.end() && speakers_.size() == kMaxSpeakers) {
    speakers_.erase(std::ranges::min_element(
        speakers_, {}, [](const auto& speaker) { return speaker.second.newest; }));
  }
  Speaker& speaker = speakers_[packet.speaker];
  speaker.newest = now;
  speaker.buffer.push({.seq = packet.seq,
                       .ends = packet.ends,
                       .capture = packet.capture_time.time_since_epoch(),
                       .opus = std::move(packet.opus)},
                      now.time_since_epoch());
}

sound::StereoBlock RoomMix::mix(const client::RoomSnapshot& room,
                                const RigidTransform& world_from_head,
                                const std::map<ViewerId, float>& volumes, HostTime now) {
  sound::StereoBlock out{};
  for (auto& [id, speaker] : speakers_) {
    const auto block = speaker.buffer.pull(now.time_since_epoch());
    if (!block) {
      speaker.was_heard = false;
      continue;
    }
    const auto place = client::world_from_speaker(room, id);
    sound::Gains gains = sound::listener_gains(
        world_from_head, place ? std::optional(place->translation_m) : std::nullopt);
    const auto volume = volumes.find(id);
    if (volume != volumes.end())
      for (float& gain : gains) gain *= volume->second;
    add(speaker, *block, gains, out);
  }
  std::ranges::transform(out, out.begin(), within_scale);
  return out;
}

/// Glides from where it was heard 20 ms ago, so that nothing clicks.
void RoomMix::add(Speaker& speaker, const voice::JitterBuffer::Block& block,
                  const sound::Gains& gains, sound::StereoBlock& out) {
  const sound::Gains before = std::exchange(speaker.was_heard, true) ? speaker.gains : gains;
  speaker.gains = gains;
  for (std::size_t i = 0; i < block.size(); ++i) {
    const float part = static_cast<float>(i) / static_cast<float>(block.size());
    for (std::size_t side = 0; side < 2; ++side)
      out[2 * i + side] += block[i] * (before[side] + part * (gains[side] - before[side]));
  }
}

std::set<ViewerId> RoomMix::speakers() const {
  std::set<ViewerId> ids;
  for (const auto& [id, speaker] : speakers_) ids.insert(id);
  return ids;
}

}  // namespace roomcast::viewer
