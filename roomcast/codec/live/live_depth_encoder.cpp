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
  drift_.resize(state_.grid);
  planner_.resize();
  memory_.resize(pixels);
  old_picture_.resize(pixels);
}

void LiveDepthEncoder::encode(DepthView depth_mm, FrameRole role, std::vector<std::uint8_t>& out,
                              BlockNeedsView needs) {
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
  const FrameRole coded_role{head.key, head.reference ? std::uint8_t{0} : role.layer};
  const std::uint32_t hash = encode_changes(writer, coded_role, needs);
  writer.finish();
  write_u32(&out[begin + kLiveHashOffset], hash);
  shown_is_reference_ = head.reference;
  started_ = true;
}

void LiveDepthEncoder::set_steps(int step, int key_step) {
  options_.step = step;
  options_.key_step = key_step;
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

// The target is the stored background where something stands before it; else the picture,
// corrected by the average of later readings. A background that is seen through, or gives no
// readings any more, has gone: coded again, it would be shown wherever the newest frame has no
// reading to the contrary.
void LiveDepthEncoder::choose_background_target() {
  for (std::size_t i = 0; i < memory_.size(); ++i) {
    const std::uint16_t old = state_.picture[i], back = state_.background[i];
    if (old != 0 && back > old) {
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
  state_.grid.for_each_block([&](const BlockView& here) { encode_background_block(pass, here); });
  pass.finish();
  state_.remember_picture_as_background();
}

void LiveDepthEncoder::encode_background_block(Pass& pass, const BlockView& here) {
  code_.mode = BlockMode::kSkip;
  code_.labels.fill(PixelLabel::kUnchanged);
  target_.fill(0);
  here.for_each_pixel([&](const BlockPixel& p) {
    if (memory_[p.at] == 0) return;
    target_[p.k] = memory_[p.at];
    code_.labels[p.k] = PixelLabel::kFirst;
    code_.mode = BlockMode::kLabels;
  });
  if (code_.mode == BlockMode::kLabels) prepare_surfaces(pass, here, options_.key_step);
  pass.block(here, code_);
}

void LiveDepthEncoder::prepare_surfaces(const Pass& pass, const BlockView& here, int step) {
  split_surfaces(code_, target_);
  bool bounded = true;
  for (std::size_t which = 0; which < code_.surface_count; ++which) {
    const PixelLabel label = which == 0 ? PixelLabel::kFirst : PixelLabel::kSecond;
    bounded = encode_surface(pass.candidates(here, which), label, step, code_, target_,
                             code_.surfaces[which]) &&
              bounded;
  }
  if (bounded) return;
  code_.mode = BlockMode::kRaw;
  here.for_each_pixel([&](const BlockPixel& p) {
    code_.readings[p.k] = wanted_level(code_.labels[p.k], target_[p.k], state_.picture[p.at],
                                       state_.background[p.at]);
  });
}

// Adapts the averages to the newly coded reference.
void LiveDepthEncoder::follow_new_reference() {
  for (std::size_t i = 0; i < old_picture_.size(); ++i) {
    const int moved = state_.picture[i] - old_picture_[i];
    if (state_.picture[i] == 0 || old_picture_[i] == 0 || std::abs(moved) > kSampleReach) {
      history_.sum[i] = 0;
      history_.count[i] = 0;
    } else {
      history_.follow(i, moved);
    }
  }
  for (std::size_t block = 0; block < state_.grid.block_count(); ++block) drift_.reset(block);
}

std::uint32_t LiveDepthEncoder::encode_changes(LiveWriter& writer, FrameRole role,
                                               BlockNeedsView needs) {
  const bool reference = role.layer == 0;
  if (!reference) {
    non_reference_contexts_ = state_.contexts;
    scratch_.shown_mm = state_.picture_mm;
  }
  drift_.update(change_, history_);
  planner_.begin_frame(reference);
  Pass pass(state_, scratch_, reference ? state_.contexts : non_reference_contexts_, writer,
            options_.step, reference, scratch_.shown_mm.data());
  const std::size_t blocks = needs.data == nullptr ? 0 : state_.grid.block_count();
  state_.grid.for_each_block([&](const BlockView& here) {
    if (here.index() < blocks && leaves_out_depth(needs.data[here.index()], role)) {
      code_.mode = BlockMode::kSkip;
      return pass.block(here, code_);
    }
    encode_block(pass, here, reference);
  });
  pass.finish();
  return pass.hash();
}

void LiveDepthEncoder::encode_block(Pass& pass, const BlockView& here, bool reference) {
  planner_.plan(here, drift_.of(here.index()), code_, target_);
  if (code_.mode == BlockMode::kLabels) prepare_surfaces(pass, here, options_.step);
  if (code_.mode == BlockMode::kSkip || !reference) return pass.block(here, code_);
  std::array<std::uint16_t, kBlockPixels> before{};
  here.for_each_pixel([&](const BlockPixel& p) { before[p.k] = state_.picture[p.at]; });
  pass.block(here, code_);
  drift_.reset(here.index());
  if (planner_.coded(here, code_, before)) drift_.expect_motion(here.index());
}

DepthView LiveDepthEncoder::shown_mm() const {
  const auto& shown = shown_is_reference_ ? state_.picture_mm : scratch_.shown_mm;
  return {shown.data(), state_.grid.width, state_.grid.height, state_.grid.width};
}

}  // namespace roomcast::codec
