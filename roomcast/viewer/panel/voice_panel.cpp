// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/panel/voice_panel.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "roomcast/client/room/speaker.h"

namespace roomcast::viewer {
namespace {

const ImVec4 kWarning = {0.95F, 0.77F, 0.33F, 1};
const ImVec4 kHeardByOthers = {0.42F, 0.82F, 0.53F, 1};
const ImVec4 kPlain = {0.62F, 0.67F, 0.73F, 1};

void sentence(const ImVec4& color, const std::string& text) {
  if (text.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

/// "default", those that there are, and the chosen one, which may be a file or gone.
void choose_device(const char* label, const std::vector<std::string>& devices,
                   std::string& chosen) {
  if (!ImGui::BeginCombo(label, chosen.c_str())) return;
  std::vector<std::string> names = {"default"};
  names.insert(names.end(), devices.begin(), devices.end());
  if (std::ranges::find(names, chosen) == names.end()) names.push_back(chosen);
  for (const std::string& name : names)
    if (ImGui::Selectable(name.c_str(), name == chosen)) chosen = name;
  ImGui::EndCombo();
}

void draw_microphone(const VoiceFacts& facts, VoiceSettings& settings) {
  ImGui::Checkbox("microphone (T)", &settings.microphone_on);
  if (!settings.microphone_on) return sentence(kPlain, "nobody hears you");
  ImGui::SameLine();
  ImGui::TextColored(facts.is_sending ? kHeardByOthers : kPlain,
                     facts.is_sending ? "the others hear you" : "silent");
  sentence(kWarning, facts.microphone_problem);
  ImGui::ProgressBar(meter_of(facts.loudness), {-1, 0.6F * ImGui::GetFontSize()}, "");
  int mode = static_cast<int>(settings.mode);
  ImGui::RadioButton("when I speak", &mode, static_cast<int>(voice::TalkMode::kVoice));
  ImGui::SameLine();
  ImGui::RadioButton("while I hold the space bar", &mode, static_cast<int>(voice::TalkMode::kPush));
  settings.mode = static_cast<voice::TalkMode>(mode);
  choose_device("from", facts.microphones, settings.microphone);
}

void draw_volume(ViewerId speaker, const client::RoomSnapshot& room, VoiceSettings& settings) {
  const std::string name = client::speaker_name(room, speaker);
  const auto known = settings.volumes.find(speaker);
  float percent = 100 * (known == settings.volumes.end() ? 1 : known->second);
  ImGui::PushID(static_cast<int>(speaker.value));
  const std::string label = name.empty() ? "viewer " + std::to_string(speaker.value) : name;
  if (ImGui::SliderFloat(label.c_str(), &percent, 0, 200, "%.0f %%"))
    settings.volumes[speaker] = std::clamp(percent, 0.F, 200.F) / 100;
  ImGui::PopID();
}

}  // namespace

float meter_of(double loudness) {
  constexpr double kQuietest_db = -60, kNothing = 1e-6;
  const double db = 20 * std::log10(std::max(loudness, kNothing));
  return static_cast<float>(std::clamp(1 - db / kQuietest_db, 0.0, 1.0));
}

void draw_voice_controls(const VoiceFacts& facts, const client::RoomSnapshot& room,
                         VoiceSettings& settings) {
  draw_microphone(facts, settings);
  ImGui::Checkbox("hear the others", &settings.hears);
  sentence(kWarning, facts.loudspeaker_problem);
  choose_device("to", facts.loudspeakers, settings.loudspeaker);
  for (const ViewerId speaker : facts.heard) {
    if (client::speaker_is_here(room, speaker)) draw_volume(speaker, room, settings);
  }
}

}  // namespace roomcast::viewer
