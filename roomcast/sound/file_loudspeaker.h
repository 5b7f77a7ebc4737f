// SPDX-License-Identifier: Apache-2.0
// FileLoudspeaker: a WAV file in the place of a loudspeaker, in real time. The file is complete
// when this is destroyed. Single-threaded.
#pragma once

#include <filesystem>
#include <memory>
#include <utility>

#include "roomcast/core/clock.h"
#include "roomcast/sound/loudspeaker.h"
#include "roomcast/sound/wav_file.h"

namespace roomcast::sound {

class FileLoudspeaker final : public Loudspeaker {
 public:
  /// Errors of WavFile::create.
  static Result<std::unique_ptr<Loudspeaker>> create(const std::filesystem::path& path);
  ~FileLoudspeaker() override;

  Result<bool> play(const StereoBlock& block, const std::stop_token& stop) override;

 private:
  FileLoudspeaker(WavFile file, HostTime begins) : file_(std::move(file)), next_(begins) {}

  WavFile file_;
  HostTime next_;  // when the next block begins
};

}  // namespace roomcast::sound
