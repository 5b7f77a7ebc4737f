// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/voice/sound_devices.h"

#include <mutex>
#include <utility>

#include <SDL2/SDL.h>

#include "roomcast/core/interruptible_wait.h"
#include "roomcast/sound/file_loudspeaker.h"
#include "roomcast/sound/file_microphone.h"
#include "roomcast/sound/microphone_source.h"

namespace roomcast::viewer {
namespace {

constexpr std::chrono::milliseconds kBlockLength{20}, kLook{4};
constexpr std::uint32_t kBytesPerInput = voice::kPacketSamples * sizeof(float);
constexpr std::uint32_t kBytesPerOutput = 2 * kBytesPerInput;
/// A device that gives or takes nothing for so long is gone.
constexpr std::chrono::seconds kDevicePatience{3};

/// SDL counts its users without a lock.
std::mutex& sdl_audio_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// What SDL keeps of a thread, such as its last error, goes with the thread.
struct SdlThread {
  SdlThread() = default;
  ~SdlThread() { SDL_TLSCleanup(); }
  SdlThread(const SdlThread&) = delete;
  SdlThread& operator=(const SdlThread&) = delete;
};

/// SDL's audio, for as long as a device needs it.
class SdlAudio {
 public:
  static Result<std::unique_ptr<SdlAudio>> begin() {
    const std::lock_guard lock(sdl_audio_mutex());
    sound::keep_alsa_quiet();  // our own message is enough
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0)
      return unavailable(std::string("this computer plays and records no sound: ") +
                         SDL_GetError());
    return std::make_unique<SdlAudio>();
  }
  SdlAudio() = default;
  ~SdlAudio() {
    const std::lock_guard lock(sdl_audio_mutex());
    SDL_QuitSubSystem(SDL_INIT_AUDIO);
  }
  SdlAudio(const SdlAudio&) = delete;
  SdlAudio& operator=(const SdlAudio&) = delete;
};

/// An open device, which runs.
class SdlDevice {
 public:
  static Result<std::unique_ptr<SdlDevice>> open(const std::string& name,
                                                 SoundDirection direction) {
    static thread_local const SdlThread kept_by_sdl;
    auto audio = SdlAudio::begin();
    if (!audio) return audio.error();
    SDL_AudioSpec wanted{};
    wanted.freq = voice::kVoiceRate_hz;
    wanted.format = AUDIO_F32SYS;
    wanted.channels = direction == SoundDirection::kIn ? 1 : 2;
    wanted.samples = 512;
    SDL_AudioSpec given{};
    constexpr int kNoChanges = 0;  // SDL converts
    const SDL_AudioDeviceID id =
        SDL_OpenAudioDevice(name == "default" ? nullptr : name.c_str(),
                            direction == SoundDirection::kIn ? 1 : 0, &wanted, &given, kNoChanges);
    const char* what = direction == SoundDirection::kIn ? "microphone" : "loudspeaker";
    if (id == 0) {
      return Error{ErrorCode::kNotFound, std::string("the ") + what + " \"" + name +
                                             "\" does not open: " + SDL_GetError()};
    }
    SDL_PauseAudioDevice(id, 0);
    return std::make_unique<SdlDevice>(*std::move(audio), id,
                                       std::string(what) + " \"" + name + "\"");
  }
  SdlDevice(std::unique_ptr<SdlAudio> audio, SDL_AudioDeviceID id, std::string name)
      : audio_(std::move(audio)), id_(id), name_(std::move(name)) {}
  ~SdlDevice() { SDL_CloseAudioDevice(id_); }
  SdlDevice(const SdlDevice&) = delete;
  SdlDevice& operator=(const SdlDevice&) = delete;

  [[nodiscard]] SDL_AudioDeviceID id() const { return id_; }
  /// Waits until `is_ready`. False: `stop` was requested.
  template <class Ready>
  Result<bool> wait(Ready is_ready, const std::stop_token& stop) const {
    const HostTime begin = SteadyClock().now();
    while (!is_ready()) {
      const bool is_gone = SDL_GetAudioDeviceStatus(id_) == SDL_AUDIO_STOPPED;
      if (is_gone || SteadyClock().now() - begin > kDevicePatience)
        return unavailable("the " + name_ + " is gone");
      if (!wait_for(kLook, stop)) return false;
    }
    return !stop.stop_requested();
  }

 private:
  std::unique_ptr<SdlAudio> audio_;
  SDL_AudioDeviceID id_;
  std::string name_;
};

class SdlMicrophone final : public sound::Microphone {
 public:
  explicit SdlMicrophone(std::unique_ptr<SdlDevice> device) : device_(std::move(device)) {}

  Result<std::optional<Block>> next(const std::stop_token& stop) override {
    const auto waiting = [this] { return SDL_GetQueuedAudioSize(device_->id()); };
    const auto went_on = device_->wait([&] { return waiting() >= kBytesPerInput; }, stop);
    if (!went_on) return went_on.error();
    if (!*went_on) return std::optional<Block>();
    const std::uint32_t later = (waiting() - kBytesPerInput) / kBytesPerInput;  // blocks
    Block block;
    SDL_DequeueAudio(device_->id(), block.samples.data(), kBytesPerInput);
    block.first_sample = SteadyClock().now() - (later + 1) * kBlockLength;
    return std::optional(block);
  }

 private:
  std::unique_ptr<SdlDevice> device_;
};

class SdlLoudspeaker final : public sound::Loudspeaker {
 public:
  explicit SdlLoudspeaker(std::unique_ptr<SdlDevice> device) : device_(std::move(device)) {}

  Result<bool> play(const sound::StereoBlock& block, const std::stop_token& stop) override {
    const auto went_on = device_->wait(
        [this] { return SDL_GetQueuedAudioSize(device_->id()) <= kBytesPerOutput; }, stop);
    if (!went_on || !*went_on) return went_on;
    if (SDL_QueueAudio(device_->id(), block.data(), kBytesPerOutput) != 0)
      return unavailable(std::string("the loudspeaker is gone: ") + SDL_GetError());
    return true;
  }

 private:
  std::unique_ptr<SdlDevice> device_;
};

}  // namespace

Result<std::unique_ptr<sound::Microphone>> open_microphone(const std::string& device) {
  if (device == "none") return invalid_argument("no microphone is chosen");
  constexpr bool kLoops = true;
  if (device.ends_with(".wav")) return sound::FileMicrophone::open(device, kLoops);
  auto opened = SdlDevice::open(device, SoundDirection::kIn);
  if (!opened) return opened.error();
  return std::unique_ptr<sound::Microphone>(std::make_unique<SdlMicrophone>(*std::move(opened)));
}

Result<std::unique_ptr<sound::Loudspeaker>> open_loudspeaker(const std::string& device) {
  if (device == "none") return std::unique_ptr<sound::Loudspeaker>();
  if (device.ends_with(".wav")) return sound::FileLoudspeaker::create(device);
  auto opened = SdlDevice::open(device, SoundDirection::kOut);
  if (!opened) return opened.error();
  return std::unique_ptr<sound::Loudspeaker>(std::make_unique<SdlLoudspeaker>(*std::move(opened)));
}

std::vector<std::string> sound_devices(SoundDirection direction) {
  std::vector<std::string> names;
  const auto audio = SdlAudio::begin();
  if (!audio) return names;
  const int is_in = direction == SoundDirection::kIn ? 1 : 0;
  const int count = SDL_GetNumAudioDevices(is_in);
  for (int i = 0; i < count; ++i)
    if (const char* name = SDL_GetAudioDeviceName(i, is_in)) names.emplace_back(name);
  return names;
}

}  // namespace roomcast::viewer
