// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/voices/spoken_voice.h"

#include <algorithm>

namespace roomcast::client {
namespace {

nanoseconds length_of(std::size_t samples) {
  return nanoseconds(static_cast<std::int64_t>(samples) * 1'000'000'000 / voice::kVoiceRate_hz);
}

}  // namespace

/// When the first of these samples was recorded.
HostTime SpokenVoice::begin(nanoseconds length, HostTime now) const {
  if (speaking_ && next_sample_ + length > now - kMaxBehind) return next_sample_;
  const HostTime begin = now - length;
  return said_until_ ? std::max(begin, *said_until_) : begin;
}

SpokenPacket SpokenVoice::packet(std::span<const float> samples, bool ends) {
  return {encoder_.encode(samples.first<voice::kPacketSamples>()), ends, {}};
}

Result<std::vector<SpokenPacket>> SpokenVoice::say(std::span<const float> samples, HostTime now) {
  const nanoseconds length = length_of(samples.size());
  const HostTime from = begin(length, now);
  if (length > kMaxAtOnce || from + length > now + kMaxAtOnce)
    return Error{ErrorCode::kTooLarge,
                 "this is more than was spoken since the last call, and only a second may be said "
                 "ahead of time"};
  if (!speaking_ || from != next_sample_) {
    encoder_.restart();
    left_over_.clear();
  }
  HostTime first = from - length_of(left_over_.size());
  left_over_.insert(left_over_.end(), samples.begin(), samples.end());
  std::span<const float> rest = left_over_;
  std::vector<SpokenPacket> packets;
  for (; rest.size() >= voice::kPacketSamples; rest = rest.subspan(voice::kPacketSamples)) {
    packets.push_back(packet(rest, false));
    packets.back().first_sample = first;
    first += length_of(voice::kPacketSamples);
  }
  left_over_.assign(rest.begin(), rest.end());
  speaking_ = true;
  next_sample_ = from + length;
  said_until_ = next_sample_;
  return packets;
}

std::optional<SpokenPacket> SpokenVoice::pause() {
  if (!speaking_) return std::nullopt;
  speaking_ = false;
  const HostTime first = next_sample_ - length_of(left_over_.size());
  left_over_.resize(voice::kPacketSamples);
  SpokenPacket last = packet(left_over_, true);
  last.first_sample = first;
  left_over_.clear();
  encoder_.restart();
  return last;
}

}  // namespace roomcast::client
