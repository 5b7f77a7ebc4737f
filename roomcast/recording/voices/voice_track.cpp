// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/voices/voice_track.h"

#include <array>
#include <cmath>
#include <cstdlib>

namespace roomcast::recording {
namespace {

constexpr std::int64_t kSamplesOfPacket = voice::kPacketSamples;
constexpr std::int32_t kFarApart = 50;  // packets: the speaker has begun anew

/// Where the first decoded sample of a packet belongs.
std::int64_t sample_at(nanoseconds time) {
  const double seconds = std::chrono::duration<double>(time).count();
  return std::llround(seconds * voice::kVoiceRate_hz) - voice::kEncoderDelaySamples;
}

}  // namespace

/// Right behind what was said last, if that is where it belongs but for a little.
std::int64_t VoiceTrack::place(std::int64_t at) const {
  return end_ && std::abs(at - *end_) <= kMaxShifted ? *end_ : at;
}

void VoiceTrack::take(const VoicePacket& packet, const Out& out) {
  const std::int64_t at = sample_at(packet.time);
  if (next_seq_) {
    const auto lost = static_cast<std::int32_t>(packet.seq - *next_seq_);
    if (lost < 0 && lost > -kFarApart) return;
    if (lost < 0) decoder_.restart();
    if (lost > 0 && end_) fill_gap(static_cast<std::uint32_t>(lost), at, out);
  }
  std::array<float, voice::kPacketSamples> samples{};
  const bool is_whole = decoder_.decode(packet.opus, samples);
  ++(is_whole ? figures_.packets : figures_.concealed);
  const std::int64_t begin = place(at);
  out(begin, samples);
  next_seq_ = packet.seq + 1;
  end_ = packet.ends ? std::nullopt : std::optional(begin + kSamplesOfPacket);
}

/// Only where the packets that are missing are all that is missing.
void VoiceTrack::fill_gap(std::uint32_t lost, std::int64_t at, const Out& out) {
  const std::int64_t expected = *end_ + std::int64_t{lost} * kSamplesOfPacket;
  if (lost > kMaxConcealed || std::abs(at - expected) > kMaxShifted) {
    end_.reset();
    return;
  }
  for (std::uint32_t i = 0; i < lost; ++i) {
    std::array<float, voice::kPacketSamples> samples{};
    decoder_.conceal(samples);
    ++figures_.concealed;
    out(*end_, samples);
    *end_ += kSamplesOfPacket;
  }
}

}  // namespace roomcast::recording
