// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/microphone_source.h"

#include "roomcast/sound/file_microphone.h"
#ifdef ROOMCAST_WITH_ALSA
#include "roomcast/sound/alsa_microphone.h"
#endif

namespace roomcast::sound {
namespace {

Result<std::unique_ptr<Microphone>> open_device(const std::string& device) {
#ifdef ROOMCAST_WITH_ALSA
  return AlsaMicrophone::open(device);
#else
  return Error{ErrorCode::kUnsupported,
               "this program was built without ALSA, so it has no "
               "microphone \"" +
                   device + "\""};
#endif
}

}  // namespace

Result<std::unique_ptr<Microphone>> open_microphone(const std::string& source, bool loops) {
  constexpr std::string_view kAlsa = "alsa:", kWav = "wav:";
  if (source == "default") return open_device(source);
  if (source.starts_with(kAlsa) && source.size() > kAlsa.size())
    return open_device(source.substr(kAlsa.size()));
  if (source.starts_with(kWav) && source.size() > kWav.size())
    return FileMicrophone::open(source.substr(kWav.size()), loops);
  if (source.ends_with(".wav")) return FileMicrophone::open(source, loops);
  return invalid_argument("\"" + source + "\" is no microphone: give " + kMicrophoneSources);
}

void keep_alsa_quiet() {
#ifdef ROOMCAST_WITH_ALSA
  silence_libasound();
#endif
}

std::vector<KnownMicrophone> known_microphones() {
  std::vector<KnownMicrophone> known;
#ifdef ROOMCAST_WITH_ALSA
  for (const AlsaInput& input : alsa_inputs())
    known.push_back({"alsa:" + input.device, input.description});
#endif
  return known;
}

}  // namespace roomcast::sound
