// SPDX-License-Identifier: Apache-2.0
// The letters of labels and of the panel: DejaVu Sans where the desktop has it, else the font that
// comes with Dear ImGui.
#pragma once

struct ImFont;
struct ImFontAtlas;

namespace roomcast::viewer {

/// Never null; the atlas owns it.
ImFont* add_font(ImFontAtlas& atlas, float height_px);

}  // namespace roomcast::viewer
