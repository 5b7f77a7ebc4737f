// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/file_microphone.h"

#include <algorithm>
#include <utility>

#include "roomcast/core/interruptible_wait.h"
#include "roomcast/sound/wav_sound.h"

namespace roomcast::sound {
namespace {

constexpr std::chrono::milliseconds kBlockTime{20};
/// A machine that slept does not say all that it missed.
constexpr std::chrono::seconds kMaxBehind{1};

}  // namespace

Result<std::unique_ptr<Microphone>> FileMicrophone::open(const std::filesystem::path& path,
                                                         bool loops) {
  auto sound = read_wav(path);
  if (!sound) return sound.error();
  const std::chrono::duration<double> length(static_cast<double>(sound->samples.size()) /
                                             sound->channels / sound->rate_hz);
  if (length > kMaxLength) {
    return Error{ErrorCode::kTooLarge,
                 path.string() + " is longer than 20 minutes, which is the most that is played"};
  }
  return std::unique_ptr<Microphone>(
      std::make_unique<FileMicrophone>(one_channel(*sound), loops, SteadyClock().now()));
}

Result<std::optional<Microphone::Block>> FileMicrophone::next(const std::stop_token& stop) {
  if (!loops_ && at_ >= samples_.size()) return std::optional<Block>();
  const HostTime now = SteadyClock().now();
  if (now - next_ > kMaxBehind) next_ = now - kBlockTime;
  if (!wait_until(next_ + kBlockTime, stop)) return std::optional<Block>();
  Block block{.samples = {}, .first_sample = next_};
  next_ += kBlockTime;
  for (float& sample : block.samples) {
    if (at_ == samples_.size() && loops_) at_ = 0;
    sample = at_ < samples_.size() ? samples_[at_++] : 0.F;
  }
  return std::optional(block);
}

}  // namespace roomcast::sound
