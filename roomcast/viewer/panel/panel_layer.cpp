// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/panel/panel_layer.h"

#include <algorithm>

#include <SDL2/SDL.h>
#include <backends/imgui_impl_opengl3.h>
#if __has_include(<backends/imgui_impl_sdl2.h>)  // its name since Dear ImGui 1.89
#include <backends/imgui_impl_sdl2.h>
#else
#include <backends/imgui_impl_sdl.h>
#endif
#include <imgui.h>

#include "roomcast/viewer/text/font_file.h"

namespace roomcast::viewer {
namespace {

constexpr float kLetterHeight_units = 15;
constexpr float kUsualDpi = 96;

/// Scale of text and controls for this screen, in desktop units.
float desktop_scale(const ViewWindow& window) {
  float dpi = kUsualDpi;
  const int screen = SDL_GetWindowDisplayIndex(window.sdl());
  if (SDL_GetDisplayDPI(screen, nullptr, &dpi, nullptr) != 0) return 1;
  return std::clamp(dpi / kUsualDpi / static_cast<float>(window.pixels_per_unit()), 1.F, 3.F);
}

}  // namespace

Result<std::unique_ptr<PanelLayer>> PanelLayer::create(const ViewWindow& window) {
  std::unique_ptr<PanelLayer> layer(new PanelLayer(window));
  if (layer->start_backends()) return layer;
  return Error{ErrorCode::kUnavailable,
               "the panel cannot be drawn: the library libGL.so is not there (apt install "
               "libgl-dev)"};
}

PanelLayer::PanelLayer(const ViewWindow& window)
    : window_(window), context_(ImGui::CreateContext()) {
  ImGui::SetCurrentContext(context_.get());
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // do not write a settings file
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  set_style();
}

void PanelLayer::set_style() {
  const float scale = desktop_scale(window_);
  const auto pixels_per_unit = static_cast<float>(window_.pixels_per_unit());
  ImGuiIO& io = ImGui::GetIO();
  add_font(*io.Fonts, kLetterHeight_units * scale * pixels_per_unit);
  io.FontGlobalScale = 1 / pixels_per_unit;
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 8;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 5;
  style.WindowBorderSize = 0;
  style.WindowPadding = {14, 12};
  style.ItemSpacing = {8, 6};
  style.ScaleAllSizes(scale);
  style.Colors[ImGuiCol_WindowBg] = {0.05F, 0.067F, 0.09F, 0.86F};
  style.Colors[ImGuiCol_Header] = {0.16F, 0.24F, 0.34F, 1};
}

bool PanelLayer::start_backends() {
  has_sdl_ = ImGui_ImplSDL2_InitForOpenGL(window_.sdl(), window_.gl_context());
  has_gl_ = has_sdl_ && ImGui_ImplOpenGL3_Init("#version 450 core");
  return has_gl_;
}

PanelLayer::~PanelLayer() {
  ImGui::SetCurrentContext(context_.get());
  if (has_gl_) ImGui_ImplOpenGL3_Shutdown();
  if (has_sdl_) ImGui_ImplSDL2_Shutdown();
}

void PanelLayer::Destroy::operator()(ImGuiContext* context) const {
  ImGui::DestroyContext(context);
}

bool PanelLayer::take(const SDL_Event& event) {
  ImGui_ImplSDL2_ProcessEvent(&event);
  const ImGuiIO& io = ImGui::GetIO();
  switch (event.type) {
    case SDL_MOUSEMOTION:
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
    case SDL_MOUSEWHEEL:
      return io.WantCaptureMouse;
    case SDL_KEYDOWN:
    case SDL_TEXTINPUT:
      return io.WantTextInput;
    default:
      return false;
  }
}

void PanelLayer::begin() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplSDL2_NewFrame();
  ImGui::NewFrame();
}

void PanelLayer::end() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace roomcast::viewer
