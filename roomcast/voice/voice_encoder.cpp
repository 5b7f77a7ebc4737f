// SPDX-License-Identifier: Apache-2.0
#include "roomcast/voice/voice_encoder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include <opus/opus.h>

#include "roomcast/core/assert.h"

namespace roomcast::voice {
namespace {

constexpr std::size_t kLargestPacket = 1275;  // RFC 6716 §3.2.1

}  // namespace

void VoiceEncoder::Destroy::operator()(OpusEncoder* encoder) const {
  opus_encoder_destroy(encoder);
}

VoiceEncoder::VoiceEncoder() {
  int fault = OPUS_OK;
  encoder_.reset(opus_encoder_create(kVoiceRate_hz, 1, OPUS_APPLICATION_VOIP, &fault));
  if (!encoder_) throw std::bad_alloc();  // there is no other reason
  opus_encoder_ctl(encoder_.get(), OPUS_SET_BITRATE(kVoiceBitsPerSecond));
}

std::vector<std::uint8_t> VoiceEncoder::encode(std::span<const float, kPacketSamples> samples) {
  std::array<float, kPacketSamples> sound{};
  std::ranges::transform(samples, sound.begin(), [](float sample) {
    return std::isfinite(sample) ? std::clamp(sample, -1.0F, 1.0F) : 0.0F;
  });
  std::vector<std::uint8_t> packet(kLargestPacket);
  const int length =
      opus_encode_float(encoder_.get(), sound.data(), static_cast<int>(kPacketSamples),
                        packet.data(), static_cast<opus_int32>(packet.size()));
  ROOMCAST_ASSERT(length > 0);  // the arguments are as libopus has them
  packet.resize(static_cast<std::size_t>(length));
  return packet;
}

void VoiceEncoder::restart() {
  opus_encoder_ctl(encoder_.get(), OPUS_RESET_STATE);
}

}  // namespace roomcast::voice
