// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/alsa_microphone.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include <alsa/asoundlib.h>

#include "roomcast/core/interruptible_wait.h"

namespace roomcast::sound {
namespace {

constexpr std::chrono::milliseconds kAlsaBlockTime{20}, kLook{100};
constexpr unsigned kBuffer_us = 200'000;
/// A device that gives nothing for so long is gone.
constexpr std::chrono::seconds kAlsaPatience{3};
/// Times of blocks are those of a steady clock unless the device's own tell of a gap.
constexpr std::chrono::milliseconds kGap{60};

void say_nothing(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/,
                 const char* /*format*/, ...) {}  // NOLINT: libasound's type

Error refusal(const std::string& device, int error) {
  switch (-error) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return {ErrorCode::kNotFound,
              "there is no microphone \"" + device + "\" on this computer; arecord -L lists them"};
    case EBUSY:
      return unavailable("another program has the microphone \"" + device + "\"");
    case EACCES:
    case EPERM:
      return unavailable("this user may not use the microphone \"" + device +
                         "\": add the user to the group audio");
    default:
      return unavailable("the microphone \"" + device + "\" does not open: " + snd_strerror(error));
  }
}

}  // namespace

void AlsaMicrophone::Close::operator()(_snd_pcm* pcm) const {
  snd_pcm_close(pcm);
}

void silence_libasound() {
  snd_lib_error_set_handler(&say_nothing);
}

Result<std::unique_ptr<Microphone>> AlsaMicrophone::open(const std::string& device) {
  silence_libasound();
  snd_pcm_t* raw = nullptr;
  if (const int error =
          snd_pcm_open(&raw, device.c_str(), SND_PCM_STREAM_CAPTURE, SND_PCM_NONBLOCK);
      error < 0)
    return refusal(device, error);
  Pcm pcm(raw);
  const int resamples = 1;
  if (snd_pcm_set_params(raw, SND_PCM_FORMAT_S16_LE, SND_PCM_ACCESS_RW_INTERLEAVED, 1,
                         voice::kVoiceRate_hz, resamples, kBuffer_us) < 0) {
    return Error{ErrorCode::kUnsupported,
                 "the microphone \"" + device +
                     "\" does not record one channel at 48 kHz; ALSA converts it under the name "
                     "plughw: instead of hw:"};
  }
  if (const int error = snd_pcm_start(raw); error < 0) return refusal(device, error);
  return std::unique_ptr<Microphone>(new AlsaMicrophone(device, std::move(pcm)));
}

/// False: `stop` was requested.
Result<bool> AlsaMicrophone::read(std::span<std::int16_t> samples, const std::stop_token& stop) {
  const HostTime begun = SteadyClock().now();
  while (!samples.empty()) {
    if (stop.stop_requested()) return false;
    const snd_pcm_sframes_t count = snd_pcm_readi(pcm_.get(), samples.data(), samples.size());
    if (count > 0) {
      samples = samples.subspan(static_cast<std::size_t>(count));
      continue;
    }
    if (count == -EAGAIN || count == 0) {
      if (SteadyClock().now() - begun > kAlsaPatience)
        return unavailable("the microphone \"" + device_ + "\" gives no sound any more");
      snd_pcm_wait(pcm_.get(), static_cast<int>(kLook.count()));
      continue;
    }
    if (snd_pcm_recover(pcm_.get(), static_cast<int>(count), 1) < 0)
      return unavailable("the microphone \"" + device_ + "\" is gone");
    next_ = {};  // samples were lost
    snd_pcm_start(pcm_.get());
  }
  return true;
}

/// When the block that was just read began.
HostTime AlsaMicrophone::begin(HostTime now) {
  snd_pcm_sframes_t waiting = 0;
  if (snd_pcm_delay(pcm_.get(), &waiting) < 0 || waiting < 0) waiting = 0;
  const HostTime measured =
      now - kAlsaBlockTime - nanoseconds(waiting * 1'000'000'000LL / voice::kVoiceRate_hz);
  const bool is_known = next_ != HostTime() && measured - next_ < kGap && next_ - measured < kGap;
  if (!is_known) return measured;
  return next_ + (measured - next_) / 50;  // the card's clock is not ours
}

Result<std::optional<Microphone::Block>> AlsaMicrophone::next(const std::stop_token& stop) {
  std::array<std::int16_t, voice::kPacketSamples> raw{};
  const auto went_on = read(raw, stop);
  if (!went_on) return went_on.error();
  if (!*went_on) return std::optional<Block>();
  Block block{.samples = {}, .first_sample = begin(SteadyClock().now())};
  next_ = block.first_sample + kAlsaBlockTime;
  std::ranges::transform(raw, block.samples.begin(),
                         [](std::int16_t value) { return static_cast<float>(value) / 32768.F; });
  // Devices without a clock of their own, such as ALSA's "null", give as much as is asked for.
  if (!wait_until(next_, stop)) return std::optional<Block>();
  return std::optional(block);
}

std::vector<AlsaInput> alsa_inputs() {
  silence_libasound();
  std::vector<AlsaInput> inputs;
  for (int card = -1; snd_card_next(&card) == 0 && card >= 0;) {
    snd_ctl_t* control = nullptr;
    const std::string name = "hw:" + std::to_string(card);
    if (snd_ctl_open(&control, name.c_str(), 0) < 0) continue;
    snd_pcm_info_t* info = nullptr;
    snd_pcm_info_malloc(&info);
    for (int device = -1; snd_ctl_pcm_next_device(control, &device) == 0 && device >= 0;) {
      snd_pcm_info_set_device(info, static_cast<unsigned>(device));
      snd_pcm_info_set_subdevice(info, 0);
      snd_pcm_info_set_stream(info, SND_PCM_STREAM_CAPTURE);
      if (snd_ctl_pcm_info(control, info) < 0) continue;
      char* card_name = nullptr;  // NOLINT: libasound's string
      const bool has_name = snd_card_get_name(card, &card_name) == 0;
      inputs.push_back(
          {"plughw:" + std::to_string(card) + "," + std::to_string(device),
           (has_name ? card_name : name) + std::string(", ") + snd_pcm_info_get_name(info)});
      if (has_name) std::free(card_name);  // NOLINT: as libasound's manual asks
    }
    snd_pcm_info_free(info);
    snd_ctl_close(control);
  }
  return inputs;
}

}  // namespace roomcast::sound
