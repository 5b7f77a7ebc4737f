// SPDX-License-Identifier: Apache-2.0
#include "roomcast/voice/echo_canceller.h"

#include <algorithm>
#include <cmath>
#include <new>

#include <speex/speex_echo.h>
#include <speex/speex_preprocess.h>

namespace roomcast::voice {
namespace {

constexpr int kFrame = static_cast<int>(kPacketSamples);
constexpr int kTailSamples = static_cast<int>(EchoCanceller::kTail.count()) * kVoiceRate_hz / 1000;
// Of what the filter leaves: dB below it, and less while somebody speaks nearby.
constexpr int kSuppressed_db = -45, kSuppressedInDoubleTalk_db = -15;
constexpr int kNoise_db = -15;

using Samples = std::array<std::int16_t, kPacketSamples>;

Samples integers(std::span<const float, kPacketSamples> sound) {
  Samples out{};
  std::ranges::transform(sound, out.begin(), [](float value) {
    const float finite = std::isfinite(value) ? std::clamp(value, -1.F, 1.F) : 0.F;
    return static_cast<std::int16_t>(std::lround(32767 * finite));
  });
  return out;
}

}  // namespace

void EchoCanceller::DestroyEcho::operator()(SpeexEchoState_* state) const {
  speex_echo_state_destroy(state);
}
void EchoCanceller::DestroyPreprocess::operator()(SpeexPreprocessState_* state) const {
  speex_preprocess_state_destroy(state);
}

EchoCanceller::EchoCanceller()
    : echo_(speex_echo_state_init(kFrame, kTailSamples)),
      preprocess_(speex_preprocess_state_init(kFrame, kVoiceRate_hz)) {
  if (!echo_ || !preprocess_) throw std::bad_alloc();  // there is no other reason
  int rate_hz = kVoiceRate_hz;
  speex_echo_ctl(echo_.get(), SPEEX_ECHO_SET_SAMPLING_RATE, &rate_hz);
  const auto set = [this](int what, int value) {
    speex_preprocess_ctl(preprocess_.get(), what, &value);
  };
  set(SPEEX_PREPROCESS_SET_DENOISE, 1);
  set(SPEEX_PREPROCESS_SET_NOISE_SUPPRESS, kNoise_db);
  set(SPEEX_PREPROCESS_SET_ECHO_SUPPRESS, kSuppressed_db);
  set(SPEEX_PREPROCESS_SET_ECHO_SUPPRESS_ACTIVE, kSuppressedInDoubleTalk_db);
  speex_preprocess_ctl(preprocess_.get(), SPEEX_PREPROCESS_SET_ECHO_STATE, echo_.get());
}

void EchoCanceller::process(std::span<float, kPacketSamples> heard,
                            std::span<const float, kPacketSamples> played) {
  const Samples microphone = integers(heard), loudspeaker = integers(played);
  Samples out{};
  speex_echo_cancellation(echo_.get(), microphone.data(), loudspeaker.data(), out.data());
  speex_preprocess_run(preprocess_.get(), out.data());
  std::ranges::transform(out, heard.begin(),
                         [](std::int16_t value) { return static_cast<float>(value) / 32768.F; });
}

void EchoCanceller::restart() {
  speex_echo_state_reset(echo_.get());
}

}  // namespace roomcast::voice
