// SPDX-License-Identifier: Apache-2.0
// The font of labels and of the panel: DejaVu Sans if the desktop has it, else Dear ImGui's own
// font.
#pragma once

struct ImFont;
struct ImFontAtlas;

namespace roomcast::viewer {

/// Never null; owned by the atlas.
ImFont* add_font(ImFontAtlas& atlas, float height_px);

}  // namespace roomcast::viewer
