// SPDX-License-Identifier: Apache-2.0
// AlsaMicrophone: a sound card's input through ALSA (libasound), and by its "default" device a
// PipeWire or PulseAudio server's. Single-threaded.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "roomcast/sound/microphone.h"

struct _snd_pcm;  // NOLINT: of libasound

namespace roomcast::sound {

class AlsaMicrophone final : public Microphone {
 public:
  /// `device` as ALSA names it: "default", "plughw:1,0", ... kNotFound: there is none of this name.
  /// kUnavailable: another program has it. kUnsupported: it records nothing at 48 kHz.
  static Result<std::unique_ptr<Microphone>> open(const std::string& device);

  Result<std::optional<Block>> next(const std::stop_token& stop) override;

 private:
  struct Close {
    void operator()(_snd_pcm* pcm) const;
  };
  using Pcm = std::unique_ptr<_snd_pcm, Close>;

  AlsaMicrophone(std::string device, Pcm pcm) : device_(std::move(device)), pcm_(std::move(pcm)) {}
  Result<bool> read(std::span<std::int16_t> samples, const std::stop_token& stop);
  [[nodiscard]] HostTime begin(HostTime now);

  const std::string device_;
  Pcm pcm_;
  HostTime next_{};  // when the sample after the last block was recorded; 0: unknown
};

/// libasound writes its complaints to the terminal unless told otherwise.
void silence_libasound();

struct AlsaInput {
  std::string device;       // as in AlsaMicrophone::open
  std::string description;  // of the card
};

/// The sound cards that record.
[[nodiscard]] std::vector<AlsaInput> alsa_inputs();

}  // namespace roomcast::sound
