// SPDX-License-Identifier: Apache-2.0
// VoiceDecoder: decodes one speaker's Opus packets with libopus (RFC 6716): 20 ms of one channel at
// 48 kHz each. Broken packets are concealed, never an error. Single-threaded.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

struct OpusDecoder;

namespace roomcast::voice {

inline constexpr int kVoiceRate_hz = 48'000;
inline constexpr std::size_t kPacketSamples = 960;  // 20 ms

/// What an Opus encoder adds at the beginning: its first sample is this long before the first one
/// that it was given (libopus, also in browsers).
inline constexpr std::int64_t kEncoderDelaySamples = 312;

class VoiceDecoder {
 public:
  VoiceDecoder();

  /// False: this is no packet of 20 ms, and `out` is a continuation of what came before.
  bool decode(std::span<const std::uint8_t> packet, std::span<float, kPacketSamples> out);
  /// What was probably said in a lost packet.
  void conceal(std::span<float, kPacketSamples> out);
  /// The speaker begins anew.
  void restart();

 private:
  struct Destroy {
    void operator()(OpusDecoder* decoder) const;
  };
  std::unique_ptr<OpusDecoder, Destroy> decoder_;
};

}  // namespace roomcast::voice
