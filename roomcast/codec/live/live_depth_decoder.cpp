// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/live_depth_decoder.h"

#include <cstring>

namespace roomcast::codec {
namespace {

void copy_picture(const std::vector<std::uint16_t>& from, ImageView<std::uint16_t> to) {
  const auto width = static_cast<std::size_t>(to.width);
  for (int y = 0; y < to.height; ++y) {
    std::memcpy(to.row(y), &from[static_cast<std::size_t>(y) * width], width * sizeof(from[0]));
  }
}

}  // namespace

Status LiveDepthDecoder::decode(std::span<const std::uint8_t> section,
                                ImageView<std::uint16_t> depth_mm) {
  std::uint32_t expected_hash = 0;
  const auto head = read_live_head(section, expected_hash);
  if (!head.ok()) return head.error();
  if (state_.grid.width != depth_mm.width || state_.grid.height != depth_mm.height) {
    if (!head->key) return malformed("Live depth begins with a key frame.");
    state_.resize(depth_mm.width, depth_mm.height);
    scratch_.resize(state_);
  }
  if (!head->key && !state_is_valid_) return malformed("The frame builds on one that is missing.");
  state_is_valid_ = state_is_valid_ && !head->reference;
  LiveReader reader(section);
  if (!head->reference) {
    if (decode_non_reference(reader, *head, depth_mm) == expected_hash) return {};
    return malformed("The frame is damaged, or builds on one that is missing.");
  }
  const std::uint32_t hash = head->key
                                 ? decode_key(reader, *head)
                                 : decode_pass(reader, state_.contexts, head->step, true, nullptr);
  if (hash != expected_hash) {
    return malformed("The frame is damaged, or builds on one that is missing.");
  }
  state_is_valid_ = true;
  copy_picture(state_.picture_mm, depth_mm);
  return {};
}

std::uint32_t LiveDepthDecoder::decode_key(LiveReader& reader, const LiveSectionHead& head) {
  state_.begin_anew(head.sigma);
  decode_pass(reader, state_.contexts, head.key_step, true, nullptr);
  state_.remember_picture_as_background();
  return decode_pass(reader, state_.contexts, head.step, true, nullptr);
}

std::uint32_t LiveDepthDecoder::decode_non_reference(LiveReader& reader,
                                                     const LiveSectionHead& head,
                                                     ImageView<std::uint16_t> depth_mm) {
  non_reference_contexts_ = state_.contexts;
  scratch_.shown_mm = state_.picture_mm;
  const std::uint32_t hash =
      decode_pass(reader, non_reference_contexts_, head.step, false, scratch_.shown_mm.data());
  copy_picture(scratch_.shown_mm, depth_mm);
  return hash;
}

std::uint32_t LiveDepthDecoder::decode_pass(LiveReader& reader, LiveContexts& contexts, int step,
                                            bool reference, std::uint16_t* shown_mm) {
  PicturePass pass(state_, scratch_, contexts, reader, step, reference, shown_mm);
  BlockCode code;
  state_.grid.for_each_block([&](const BlockView& here) { pass.block(here, code); });
  pass.finish();
  return pass.hash();
}

}  // namespace roomcast::codec
