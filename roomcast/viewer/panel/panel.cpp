// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/panel/panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <imgui.h>

#include "roomcast/viewer/panel/voice_panel.h"

namespace roomcast::viewer {
namespace {

const ImVec4 kRed = {0.96F, 0.42F, 0.38F, 1};
const ImVec4 kYellow = {0.95F, 0.77F, 0.33F, 1};
const ImVec4 kGreen = {0.42F, 0.82F, 0.53F, 1};
const ImVec4 kQuiet = {0.62F, 0.67F, 0.73F, 1};
constexpr double kDegrees = 180 / std::numbers::pi;
constexpr float kMargin = 12;
// In letters' heights.
constexpr float kPanelWidth = 25, kLowestPanel = 8;
constexpr float kToastsWidth = 34, kNarrowToasts = 18;
constexpr float kHelpWidth = 40, kHelpKeysShare = 0.32F;

ImVec4 color_of(Toast::Kind kind) {
  switch (kind) {
    case Toast::Kind::kError:
      return kRed;
    case Toast::Kind::kNotice:
      return kYellow;
    case Toast::Kind::kGood:
      return kGreen;
  }
  return kQuiet;
}

float letter() {
  return ImGui::GetFontSize();
}

void wrapped(const ImVec4& color, const std::string& sentence) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextWrapped("%s", sentence.c_str());
  ImGui::PopStyleColor();
}

/// A label on the left, a figure on the right.
void figure(const char* label, const char* format, auto... values) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextColored(kQuiet, "%s", label);
  ImGui::TableNextColumn();
  ImGui::Text(format, values...);
}

bool begin_figures(const char* name) {
  if (!ImGui::BeginTable(name, 2)) return false;
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, 9 * letter());
  ImGui::TableSetupColumn("figure");
  return true;
}

bool section(const char* title, bool is_open = true) {
  return ImGui::CollapsingHeader(title, is_open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

void draw_connection(const PanelFacts& facts) {
  const client::RoomSnapshot& room = facts.room;
  ImGui::TextColored(room.connected ? kGreen : kRed, room.connected ? "live" : "not connected");
  ImGui::SameLine();
  ImGui::Text("%s", room.room.empty() ? "roomcast" : room.room.c_str());
  ImGui::SameLine();
  ImGui::TextColored(kQuiet, "(Tab: this panel)");
}

void draw_rates(const PanelFacts& facts) {
  if (!section("Rates") || !begin_figures("rates")) return;
  figure("received", "%.2f MB/s", facts.figures.megabytes_per_s);
  figure("frame sets", "%.1f per s", facts.figures.sets_per_s);
  figure("drawn", "%.1f per s, %d x %d%s", facts.drawn_per_s, facts.size.width, facts.size.height,
         facts.is_worn ? " per eye" : "");
  figure("drawing takes", "%.1f ms", facts.drawing_ms);
  ImGui::EndTable();
}

void optional_ms(const char* label, const std::optional<double>& value) {
  if (value) {
    figure(label, "%.1f ms", *value);
  } else {
    figure(label, "%s", "not known yet");
  }
}

void draw_latency(const PanelFacts& facts) {
  if (!section("From sensor to screen") || !begin_figures("latency")) return;
  if (const auto& stages = facts.latency) {
    optional_ms("sensor, net, hub", stages->to_here_ms);
    figure("decoding", "%.1f ms", stages->decoding_ms);
    figure("waiting", "%.1f ms", stages->waiting_ms);
    figure("drawing", "%.1f ms", stages->drawing_ms);
    optional_ms("in all", stages->total_ms);
    if (stages->clock_error_ms) figure("clock error", "up to %.1f ms", *stages->clock_error_ms);
  } else {
    figure("in all", "%s", "no picture in the last second");
  }
  ImGui::EndTable();
}

void draw_placement(const client::RoomSensor& sensor) {
  if (sensor.pose.is_moved()) {
    ImGui::TextColored(kYellow, "moved");
  } else if (!sensor.pose.is_placed()) {
    ImGui::TextColored(kYellow, "not placed");
  } else if (sensor.pose.state == PoseState::kUnverified) {
    ImGui::TextColored(kYellow, "not verified");
  } else if (sensor.pose.expected_error_mm > 0) {
    ImGui::TextColored(kGreen, "+- %.0f mm",
                       std::max(1.0, std::round(sensor.pose.expected_error_mm)));
  } else {
    ImGui::TextColored(kGreen, "placed");
  }
}

void draw_sensor(const client::RoomSensor& sensor, const SensorFigures& figures,
                 ViewSettings& settings) {
  ImGui::PushID(sensor.id.value);
  bool is_shown = !settings.hidden.contains(sensor.id);
  if (ImGui::Checkbox(sensor.name.c_str(), &is_shown)) {
    if (is_shown) {
      settings.hidden.erase(sensor.id);
    } else {
      settings.hidden.insert(sensor.id);
    }
  }
  ImGui::SameLine();
  if (sensor.online) {
    draw_placement(sensor);
  } else {
    ImGui::TextColored(kRed, "gone");
  }
  ImGui::Indent();
  if (sensor.online) {
    ImGui::TextColored(kQuiet, "%.1f fps, %.2f MB/s, %llu missed", figures.fps,
                       figures.megabytes_per_s, static_cast<unsigned long long>(figures.missed));
    ImGui::SameLine();
    if (figures.age_ms) ImGui::TextColored(kQuiet, "%.0f ms old", *figures.age_ms);
    if (sensor.is_small || sensor.is_held_back) {
      ImGui::SameLine();
      ImGui::TextColored(kYellow, "coarse: your line takes no more");
    }
    ImGui::NewLine();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);
  }
  if (!sensor.pose.note.empty()) ImGui::TextWrapped("%s", sensor.pose.note.c_str());
  ImGui::Unindent();
  ImGui::PopID();
}

void draw_sensors(const PanelFacts& facts, ViewSettings& settings) {
  if (!section("Sensors and their alignment")) return;
  if (facts.room.sensors.empty()) ImGui::TextColored(kQuiet, "none yet");
  const std::size_t count = std::min(facts.room.sensors.size(), facts.figures.sensors.size());
  for (std::size_t i = 0; i < count; ++i)
    draw_sensor(facts.room.sensors[i], facts.figures.sensors[i], settings);
}

void draw_voice(const PanelFacts& facts, VoiceSettings& settings) {
  if (facts.voice && section("Voice")) draw_voice_controls(*facts.voice, facts.room, settings);
}

void draw_people(const PanelFacts& facts) {
  if (!section("People")) return;
  for (const client::RoomPerson& person : facts.room.people) {
    const ImVec4 color(static_cast<float>(person.color.r) / 255,
                       static_cast<float>(person.color.g) / 255,
                       static_cast<float>(person.color.b) / 255, 1);
    const std::string number = "viewer " + std::to_string(person.id.value);
    ImGui::PushID(static_cast<int>(person.id.value));
    ImGui::ColorButton("color", color, ImGuiColorEditFlags_NoTooltip, {letter(), letter()});
    ImGui::PopID();
    ImGui::SameLine();
    ImGui::Text("%s%s", person.name.empty() ? number.c_str() : person.name.c_str(),
                person.id == facts.room.self ? " (you)" : "");
    if (person.speaking || person.muted) {
      ImGui::SameLine();
      ImGui::TextColored(person.muted ? kYellow : kGreen, person.muted ? "muted" : "speaks");
    }
  }
}

void draw_mode(ViewSettings& settings) {
  if (ImGui::BeginCombo("way of drawing", name_of(settings.mode).data())) {
    for (const render::RenderMode mode : render::kViewModes) {
      if (ImGui::Selectable(name_of(mode).data(), settings.mode == mode)) settings.mode = mode;
    }
    ImGui::EndCombo();
  }
  if (settings.mode == render::RenderMode::kBlend) {
    int unseen = static_cast<int>(settings.unseen);
    ImGui::Combo("unseen areas", &unseen, "left empty\0small holes filled\0surroundings\0");
    settings.unseen = static_cast<render::Unseen>(unseen);
  }
}

void draw_settings(const PanelFacts& facts, ViewSettings& settings) {
  if (!section("Drawn as")) return;
  draw_mode(settings);
  ImGui::Checkbox("as fine as it keeps up", &settings.automatic_scale);
  if (!settings.automatic_scale) {
    auto percent = static_cast<int>(std::lround(100 * settings.render_scale));
    ImGui::SliderInt("pixels", &percent, 25, 100, "%d %%");
    settings.render_scale = std::clamp(percent, 25, 100) / 100.0;
  }
  auto fov_deg = static_cast<float>(settings.vertical_fov_rad * kDegrees);
  ImGui::SliderFloat("field of view", &fov_deg, 30, 110, "%.0f deg");
  settings.vertical_fov_rad = std::clamp(static_cast<double>(fov_deg), 30.0, 110.0) / kDegrees;
  ImGui::Checkbox("lines on the floor", &settings.floor_grid);
  ImGui::TextColored(kQuiet, "%s", facts.driver.c_str());
}

void draw_headset(const PanelFacts& facts, ComfortOptions& comfort) {
  if (facts.headset.empty() || !section("Headset")) return;
  ImGui::TextWrapped("%s", facts.headset.c_str());
  ImGui::Checkbox("walk with the stick (else teleport)", &comfort.smooth_walk);
  ImGui::Checkbox("left-handed: hands swapped", &comfort.left_handed);
  if (facts.may_see_through) ImGui::Checkbox("your own room around it", &comfort.sees_through);
  ImGui::Checkbox("turn by steps", &comfort.snap_turn);
  if (comfort.snap_turn) {
    auto step_deg = static_cast<float>(comfort.snap_rad * kDegrees);
    ImGui::SliderFloat("step", &step_deg, 15, 90, "%.0f deg");
    comfort.snap_rad = std::clamp(static_cast<double>(step_deg), 15.0, 90.0) / kDegrees;
  }
}

std::optional<ViewerCommand> draw_buttons(const PanelFacts& facts) {
  const std::pair<const char*, ViewerCommand> buttons[] = {
      {"start (R)", ViewerCommand::kStart},
      {"picture (P)", ViewerCommand::kScreenshot},
      {facts.video.empty() ? "video (V)" : "stop (V)", ViewerCommand::kVideo},
      {"help (H)", ViewerCommand::kHelp}};
  std::optional<ViewerCommand> pressed;
  for (const auto& [label, command] : buttons) {
    const bool keeps = command == ViewerCommand::kScreenshot || command == ViewerCommand::kVideo;
    if (command != ViewerCommand::kStart) ImGui::SameLine();
    ImGui::BeginDisabled(keeps && !facts.room.rights.may_record);
    if (ImGui::Button(label)) pressed = command;
    ImGui::EndDisabled();
  }
  if (const Status may = client::check_may_record(facts.room.rights); facts.room.connected && !may)
    ImGui::TextColored(kQuiet, "%s", may.error().message.c_str());
  if (!facts.video.empty()) ImGui::TextColored(kRed, "recording %s", facts.video.c_str());
  return pressed;
}

void draw_keys(std::span<const KeyHelp> keys) {
  for (const KeyHelp& help : keys) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", help.keys.data());
    ImGui::TableNextColumn();
    wrapped(kQuiet, help.what.data());
  }
}

/// In the middle, opaque, and never larger than the window: the wheel scrolls.
void draw_help(bool with_headset) {
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const float width = std::min(kHelpWidth * letter(), all.x - 2 * kMargin);
  ImGui::SetNextWindowPos({all.x / 2, all.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, all.y - 2 * kMargin});
  ImGui::SetNextWindowBgAlpha(1);
  ImGui::Begin("Keys", nullptr,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar |
                   ImGuiWindowFlags_NoSavedSettings);
  if (ImGui::BeginTable("keys", 2)) {
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthStretch, kHelpKeysShare);
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch, 1 - kHelpKeysShare);
    draw_keys(kKeyHelp);
    if (with_headset) draw_keys(kHeadsetHelp);
    ImGui::EndTable();
  }
  ImGui::End();
}

float panel_width() {
  return std::min(kPanelWidth * letter(), ImGui::GetIO().DisplaySize.x - 2 * kMargin);
}

}  // namespace

/// At the lower right; beside the panel where there is space for it, else over the panel, which
/// then gets shorter.
void Panel::draw_toasts(const std::vector<Toast>& toasts) {
  toasts_over_panel_ = 0;
  if (toasts.empty()) return;
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const float beside = all.x - panel_width() - 3 * kMargin;
  const bool covers_panel = is_open_ && beside < kNarrowToasts * letter();
  const float space = is_open_ && !covers_panel ? beside : all.x - 2 * kMargin;
  const float width = std::min(kToastsWidth * letter(), space);
  ImGui::SetNextWindowPos({all.x - kMargin, all.y - kMargin}, ImGuiCond_Always, {1, 1});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, all.y - 2 * kMargin});
  if (covers_panel) ImGui::SetNextWindowBgAlpha(1);
  ImGui::Begin("toasts", nullptr,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoDecoration |
                   ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  for (const Toast& toast : toasts) wrapped(color_of(toast.kind), toast.sentence);
  if (covers_panel) toasts_over_panel_ = ImGui::GetWindowHeight() + kMargin;
  ImGui::End();
}

std::optional<ViewerCommand> Panel::draw(const PanelFacts& facts, ViewSettings& settings) {
  const auto pressed = is_open_ ? draw_sections(facts, settings) : std::nullopt;
  draw_toasts(facts.toasts);
  if (shows_help_) draw_help(!facts.headset.empty() || !facts.no_headset.empty());
  return pressed;
}

/// Stays behind toasts and help, even when it is clicked.
std::optional<ViewerCommand> Panel::draw_sections(const PanelFacts& facts, ViewSettings& settings) {
  const float width = panel_width();
  const float height = ImGui::GetIO().DisplaySize.y - 2 * kMargin - toasts_over_panel_;
  ImGui::SetNextWindowPos({kMargin, kMargin});
  ImGui::SetNextWindowSizeConstraints({width, 0},
                                      {width, std::max(height, kLowestPanel * letter())});
  ImGui::Begin("roomcast", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PushItemWidth(10 * letter());
  draw_connection(facts);
  const auto pressed = draw_buttons(facts);
  if (!facts.no_headset.empty()) wrapped(kYellow, facts.no_headset);
  draw_rates(facts);
  draw_latency(facts);
  draw_sensors(facts, settings);
  draw_people(facts);
  draw_voice(facts, settings.voice);
  draw_settings(facts, settings);
  draw_headset(facts, settings.comfort);
  ImGui::PopItemWidth();
  ImGui::End();
  return pressed;
}

}  // namespace roomcast::viewer
