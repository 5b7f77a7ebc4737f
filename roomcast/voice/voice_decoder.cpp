// SPDX-License-Identifier: Apache-2.0
#include "roomcast/voice/voice_decoder.h"

#include <algorithm>
#include <new>

#include <opus/opus.h>

namespace roomcast::voice {
namespace {

constexpr int kMono = 1;

}  // namespace

void VoiceDecoder::Destroy::operator()(OpusDecoder* decoder) const {
  opus_decoder_destroy(decoder);
}

VoiceDecoder::VoiceDecoder() {
  int fault = OPUS_OK;
  decoder_.reset(opus_decoder_create(kVoiceRate_hz, kMono, &fault));
  if (!decoder_) throw std::bad_alloc();  // there is no other reason
}

bool VoiceDecoder::decode(std::span<const std::uint8_t> packet,
                          std::span<float, kPacketSamples> out) {
  const auto length = static_cast<opus_int32>(packet.size());
  constexpr int kSamples = kPacketSamples;
  const bool is_whole =
      !packet.empty() &&
      opus_packet_get_nb_samples(packet.data(), length, kVoiceRate_hz) == kSamples &&
      opus_decode_float(decoder_.get(), packet.data(), length, out.data(), kSamples, 0) == kSamples;
  if (!is_whole) conceal(out);
  return is_whole;
}

void VoiceDecoder::conceal(std::span<float, kPacketSamples> out) {
  constexpr int kSamples = kPacketSamples;
  if (opus_decode_float(decoder_.get(), nullptr, 0, out.data(), kSamples, 0) != kSamples)
    std::ranges::fill(out, 0.0F);
}

void VoiceDecoder::restart() {
  opus_decoder_ctl(decoder_.get(), OPUS_RESET_STATE);
}

}  // namespace roomcast::voice
