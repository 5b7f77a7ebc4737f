// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/live_depth_encoder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "roomcast/codec/live/surface_coder.h"
#include "roomcast/core/little_endian.h"

namespace roomcast::codec {
namespace {

/// Target level of a pixel, from its label.
std::uint16_t wanted_level(PixelLabel label, float target, std::uint16_t old, std::uint16_t back) {
  switch (label) {
    case PixelLabel::kUnchanged:
      return old;
    case PixelLabel::kBackground:
      return back;
    case PixelLabel::kVanished:
      return 0;
    default:
      return static_cast<std::uint16_t>(target > 0 ? std::lround(target) : old);
  }
}

}  // namespace

LiveDepthEncoder::LiveDepthEncoder(const LiveDepthOptions& options)
    : options_(options), planner_(state_, history_, change_) {
  state_.resize(options.width, options.height);
  scratch_.resize(state_);
  const std::size_t pixels = state_.picture.size();
  analysis_.resize(options.width, options.height);
  history_.resize(pixels);
  change_.resize(pixels);
  drift_.resize(options.width, options.height, state_.blocks_wide, state_.blocks_high);
  planner_.resize();
  memory_.resize(pixels);
  old_picture_.resize(pixels);
}

void LiveDepthEncoder::encode(DepthView depth_mm, FrameRole role, std::vector<std::uint8_t>& out) {
  noise_.observe(depth_mm);
  LiveSectionHead head;
  head.key = role.key || !started_;
  head.reference = head.key || role.layer == 0;
  head.step = static_cast<std::uint8_t>(options_.step);
  head.key_step = static_cast<std::uint8_t>(options_.key_step);
  if (head.key) head.sigma = noise_.table();

  const std::size_t begin = out.size();
  write_live_head(head, out);
  LiveWriter writer(out);
  if (head.key) {
    begin_anew(head.sigma);
    analysis_.take_reading(depth_mm, state_.domain, change_);
    if (!started_) memory_ = change_.reading;
    encode_background(writer);
    follow_new_reference();
  } else {
    analysis_.take_reading(depth_mm, state_.domain, change_);
  }
  analysis_.compare(state_, history_, change_);
  const std::uint32_t hash = encode_changes(writer, head.reference);
  writer.finish();
  write_u32(&out[begin + kLiveHashOffset], hash);
  shown_is_reference_ = head.reference;
  started_ = true;
}

// Clears the state as decoders do, and converts the encoder's own memory to the new scale of
// levels.
void LiveDepthEncoder::begin_anew(const SigmaCodes& sigma) {
  old_picture_ = state_.picture;
  choose_background_target();
  old_domain_ = state_.domain;
  state_.begin_anew(sigma);
  for (auto* plane : {&memory_, &old_picture_}) {
    for (std::uint16_t& level : *plane) level = state_.domain.level_of(old_domain_.mm_of(level));
  }
}

// The target is the stored background where it differs from the picture; else the picture,
// corrected by the average of later readings.
void LiveDepthEncoder::choose_background_target() {
  for (std::size_t i = 0; i < memory_.size(); ++i) {
    const std::uint16_t old = state_.picture[i], back = state_.background[i];
    if (back != 0 && back != old) {
      memory_[i] = back;
    } else if (old == 0 || history_.count[i] < 4) {
      memory_[i] = old;
    } else {
      memory_[i] = static_cast<std::uint16_t>(
          std::clamp(old + history_.sum[i] / history_.count[i], 1, kMaxLevel));
    }
  }
}

void LiveDepthEncoder::encode_background(LiveWriter& writer) {
  Pass pass(state_, scratch_, state_.contexts, writer, options_.key_step, true, nullptr);
  for (int by = 0; by < state_.blocks_high; ++by) {
    for (int bx = 0; bx < state_.blocks_wide; ++bx) encode_background_block(pass, bx, by);
  }
  pass.finish();
  state_.remember_picture_as_background();
}

void LiveDepthEncoder::encode_background_block(Pass& pass, int bx, int by) {
  code_.mode = BlockMode::kSkip;
  code_.labels.fill(PixelLabel::kUnchanged);
  target_.fill(0);
  for (int y = by * kBlockSide; y < std::min(state_.height, (by + 1) * kBlockSide); ++y) {
    for (int x = bx * kBlockSide; x < std::min(state_.width, (bx + 1) * kBlockSide); ++x) {
      const std::uint16_t wanted =
          memory_[static_cast<std::size_t>(y) * static_cast<std::size_t>(state_.width) +
                  static_cast<std::size_t>(x)];
      if (wanted == 0) continue;
      const auto k = static_cast<std::size_t>(y % kBlockSide * kBlockSide + x % kBlockSide);
      target_[k] = wanted;
      code_.labels[k] = PixelLabel::kFirst;
      code_.mode = BlockMode::kLabels;
    }
  }
  if (code_.mode == BlockMode::kLabels)
    prepare_surfaces(pass, bx, by, options_.key_step, code_, target_);
  pass.block(bx, by, code_);
}

void LiveDepthEncoder::prepare_surfaces(Pass& pass, int bx, int by, int step, BlockCode& code,
                                        BlockTarget& target) {
  split_surfaces(code, target);
  bool bounded = true;
  for (std::size_t which = 0; which < code.surface_count; ++which) {
    const SurfaceCandidates candidates =
        surface_candidates(state_, scratch_.trace, bx, by, which, pass.last_surface(which));
    const PixelLabel label = which == 0 ? PixelLabel::kFirst : PixelLabel::kSecond;
    bounded =
        encode_surface(candidates, label, step, code, target, code.surfaces[which]) && bounded;
  }
  if (bounded) return;
  code.mode = BlockMode::kRaw;
  for (int y = by * kBlockSide; y < std::min(state_.height, (by + 1) * kBlockSide); ++y) {
    for (int x = bx * kBlockSide; x < std::min(state_.width, (bx + 1) * kBlockSide); ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(state_.width) +
                             static_cast<std::size_t>(x);
      const auto k = static_cast<std::size_t>(y % kBlockSide * kBlockSide + x % kBlockSide);
      code.readings[k] =
          wanted_level(code.labels[k], target[k], state_.picture[at], state_.background[at]);
    }
  }
}

// Adapts the averages to the newly coded reference.
void LiveDepthEncoder::follow_new_reference() {
  for (std::size_t i = 0; i < old_picture_.size(); ++i) {
    const int moved = state_.picture[i] - old_picture_[i];
    if (state_.picture[i] == 0 || old_picture_[i] == 0 || std::abs(moved) > kSampleReach) {
      history_.sum[i] = 0;
      history_.count[i] = 0;
    } else {
      history_.sum[i] = static_cast<std::int16_t>(
          std::clamp(history_.sum[i] - moved * history_.count[i], -8000, 8000));
    }
  }
  for (std::size_t block = 0; block < state_.block_count(); ++block) drift_.reset(block);
}

std::uint32_t LiveDepthEncoder::encode_changes(LiveWriter& writer, bool reference) {
  if (!reference) {
    non_reference_contexts_ = state_.contexts;
    scratch_.shown_mm = state_.picture_mm;
  }
  drift_.update(change_, history_);
  planner_.begin_frame(reference);
  Pass pass(state_, scratch_, reference ? state_.contexts : non_reference_contexts_, writer,
            options_.step, reference, scratch_.shown_mm.data());
  for (int by = 0; by < state_.blocks_high; ++by) {
    for (int bx = 0; bx < state_.blocks_wide; ++bx) {
      encode_block(pass, bx, by, reference);
    }
  }
  pass.finish();
  return pass.hash();
}

void LiveDepthEncoder::encode_block(Pass& pass, int bx, int by, bool reference) {
  const auto block = static_cast<std::size_t>(by * state_.blocks_wide + bx);
  planner_.plan(bx, by, drift_.drifts(block), code_, target_);
  if (code_.mode == BlockMode::kLabels)
    prepare_surfaces(pass, bx, by, options_.step, code_, target_);
  if (code_.mode == BlockMode::kSkip || !reference) return pass.block(bx, by, code_);
  std::array<std::uint16_t, kBlockPixels> before{};
  for (int y = by * kBlockSide; y < std::min(state_.height, (by + 1) * kBlockSide); ++y) {
    for (int x = bx * kBlockSide; x < std::min(state_.width, (bx + 1) * kBlockSide); ++x) {
      before[static_cast<std::size_t>(y % kBlockSide * kBlockSide + x % kBlockSide)] =
          state_.picture[static_cast<std::size_t>(y) * static_cast<std::size_t>(state_.width) +
                         static_cast<std::size_t>(x)];
    }
  }
  pass.block(bx, by, code_);
  drift_.reset(block);
  if (planner_.coded(bx, by, code_, before)) drift_.expect_motion(block);
}

DepthView LiveDepthEncoder::shown_mm() const {
  const auto& shown = shown_is_reference_ ? state_.picture_mm : scratch_.shown_mm;
  return {shown.data(), state_.width, state_.height, state_.width};
}

}  // namespace roomcast::codec
