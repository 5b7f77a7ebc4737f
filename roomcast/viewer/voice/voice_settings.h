// SPDX-License-Identifier: Apache-2.0
// What a person chooses about voice in the desktop viewer, and what the viewer tells about it.
// Plain data.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "roomcast/core/ids.h"
#include "roomcast/voice/talk_gate.h"

namespace roomcast::viewer {

/// Devices: "default", "none", the name of one, or a file that ends in .wav.
struct VoiceSettings {
  bool microphone_on = false;
  voice::TalkMode mode = voice::TalkMode::kVoice;
  bool is_pushed = false;  // the key for push to talk is held
  bool hears = true;
  std::string microphone = "default", loudspeaker = "default";
  std::map<ViewerId, float> volumes;  // of speakers; 1: as they are sent, also if absent

  friend bool operator==(const VoiceSettings&, const VoiceSettings&) = default;
};

struct VoiceFacts {
  bool is_sending = false;          // the others hear what the microphone records
  double loudness = 0;              // of the microphone: root of the mean square
  std::string microphone_problem;   // why it is not heard, a sentence; empty: nothing is wrong
  std::string loudspeaker_problem;  // why nothing is heard, likewise
  std::vector<std::string> microphones, loudspeakers;  // names of devices
  std::set<ViewerId> heard;  // speakers who have been heard, whose volume can be set
};

}  // namespace roomcast::viewer
