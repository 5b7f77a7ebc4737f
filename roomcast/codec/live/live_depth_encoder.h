// SPDX-License-Identifier: Apache-2.0
// Encodes depth without temporal noise: sections of codec 2. Static surfaces are sent once and
// refined as noise averages out; moving ones are sent as smooth surfaces with outlines.
// docs/spec/codec.md §2.4. Any decision here may change without a new format.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/codec/live/block_planner.h"
#include "roomcast/codec/live/drift_detector.h"
#include "roomcast/codec/live/live_section.h"
#include "roomcast/codec/live/live_state.h"
#include "roomcast/codec/live/picture_pass.h"
#include "roomcast/codec/live/pixel_history.h"
#include "roomcast/codec/live/sensor_noise.h"
#include "roomcast/codec/payload/block_need.h"
#include "roomcast/codec/payload/layer_schedule.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

struct LiveDepthOptions {
  int width = 0, height = 0;
  int step = 5 * kLevelsPerSigma / 2;  // quantiser of moving surfaces, levels
  // Quantiser of the background in key frames, levels. Finer: a coarse background would be
  // corrected for seconds, block by block, which costs more.
  int key_step = 3 * kLevelsPerSigma / 2;
};

class LiveDepthEncoder {
 public:
  explicit LiveDepthEncoder(const LiveDepthOptions& options);

  /// Appends a section's bytes. `depth_mm` has the size of the options. The first frame's role is a
  /// key frame's; frames of layer 1 and up are not references. `needs` has one entry for each
  /// block; empty: all of everything.
  void encode(DepthView depth_mm, FrameRole role, std::vector<std::uint8_t>& out,
              BlockNeedsView needs = {});

  /// Sets the quantisers from the next frame on, in levels; LiveDepthOptions.
  void set_steps(int step, int key_step);

  /// The last frame as decoders show it.
  [[nodiscard]] DepthView shown_mm() const;
  [[nodiscard]] const LiveState& state() const { return state_; }

 private:
  using Pass = PicturePass<LiveWriter>;
  void encode_background(LiveWriter& writer);
  void begin_anew(const SigmaCodes& sigma);
  void choose_background_target();
  void encode_background_block(Pass& pass, const BlockView& here);
  std::uint32_t encode_changes(LiveWriter& writer, FrameRole role, BlockNeedsView needs);
  void encode_block(Pass& pass, const BlockView& here, bool reference);
  void prepare_surfaces(const Pass& pass, const BlockView& here, int step);
  void follow_new_reference();

  LiveDepthOptions options_;
  LiveState state_;
  PassScratch scratch_;
  LiveContexts non_reference_contexts_;
  SensorNoise noise_;
  ChangeAnalysis analysis_;
  PixelHistory history_;
  FrameChange change_;
  DriftDetector drift_;
  BlockPlanner planner_;
  BlockCode code_;
  BlockTarget target_{};
  std::vector<std::uint16_t> memory_;       // target of the first pass of a key frame
  DepthDomain old_domain_;                  // the scale of levels before a key frame
  std::vector<std::uint16_t> old_picture_;  // the reference before a key frame
  bool started_ = false;                    // a key frame has been encoded
  bool shown_is_reference_ = true;
};

}  // namespace roomcast::codec
