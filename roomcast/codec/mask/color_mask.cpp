// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/mask/color_mask.h"

#include <utility>

#include "roomcast/codec/mask/intra_mask.h"
#include "roomcast/codec/mask/mask_change.h"
#include "roomcast/codec/payload/payload_sections.h"

namespace roomcast::codec {
namespace {

/// Does not reallocate an image that already has the size.
void make_size(MaskImage& image, DepthView like) {
  if (!same_size(image.view(), like)) image.resize(like.width, like.height);
}

/// The mask to show: 255 only where there is a reading.
void show(const MaskImage& known, DepthView depth_mm, ImageView<std::uint8_t> mask) {
  for (int y = 0; y < mask.height; ++y) {
    const std::uint8_t* from = known.view().row(y);
    const std::uint16_t* depth = depth_mm.row(y);
    std::uint8_t* to = mask.row(y);
    for (int x = 0; x < mask.width; ++x) to[x] = depth[x] != 0 && from[x] != 0 ? 255 : 0;
  }
}

}  // namespace

void ColorMaskEncoder::encode(MaskView mask, DepthView depth_mm, FrameRole role,
                              std::vector<std::uint8_t>& out) {
  if (role.key) {
    make_size(reference_, depth_mm);
    encode_intra_mask(mask, depth_mm, reference_.view(), out);
    return;
  }
  const bool becomes_reference = role.layer == 0;
  out.push_back(becomes_reference);
  now_ = reference_;
  encode_mask_change(mask, depth_mm, now_.view(), out);
  if (becomes_reference) std::swap(now_, reference_);
}

Status ColorMaskDecoder::decode(std::uint8_t codec, std::span<const std::uint8_t> section,
                                DepthView depth_mm, ImageView<std::uint8_t> mask) {
  if (codec == kIntraMask) {
    make_size(reference_, depth_mm);
    decode_intra_mask(section, depth_mm, reference_.view());
    show(reference_, depth_mm, mask);
    return {};
  }
  if (section.empty() || section[0] > 1) {
    return malformed("The colour mask has no legal first byte.");
  }
  if (!same_size(reference_.view(), depth_mm)) {
    return malformed("The colour mask builds on one that never came.");
  }
  now_ = reference_;
  decode_mask_change(section.subspan(1), depth_mm, now_.view());
  show(now_, depth_mm, mask);
  if (section[0] == 1) std::swap(now_, reference_);
  return {};
}

}  // namespace roomcast::codec
