// SPDX-License-Identifier: Apache-2.0
// Decodes live depth: sections of codec 2. docs/spec/codec.md §2.4. Accepts any bytes safely; work
// is bounded by the picture's size.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/codec/live/live_section.h"
#include "roomcast/codec/live/live_state.h"
#include "roomcast/codec/live/picture_pass.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::codec {

/// Keeps its memory from frame to frame.
class LiveDepthDecoder {
 public:
  /// Writes every pixel of `depth_mm`. kMalformed: damaged, or depends on a frame that was not
  /// decoded; the picture must then not be shown, and after a failed reference only a key frame
  /// recovers. kUnsupported: of a later version.
  Status decode(std::span<const std::uint8_t> section, ImageView<std::uint16_t> depth_mm);

  /// The state after the last frame; tests compare it with the encoder's.
  [[nodiscard]] const LiveState& state() const { return state_; }

 private:
  std::uint32_t decode_pass(LiveReader& reader, LiveContexts& contexts, int step, bool reference,
                            std::uint16_t* shown_mm);
  std::uint32_t decode_key(LiveReader& reader, const LiveSectionHead& head);
  std::uint32_t decode_non_reference(LiveReader& reader, const LiveSectionHead& head,
                                     ImageView<std::uint16_t> depth_mm);

  LiveState state_;
  PassScratch scratch_;
  LiveContexts non_reference_contexts_;  // for frames that are no reference
  bool state_is_valid_ = false;          // the state equals the encoder's
};

}  // namespace roomcast::codec
