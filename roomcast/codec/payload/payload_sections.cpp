// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/payload/payload_sections.h"

#include "roomcast/core/little_endian.h"

namespace roomcast::codec {
namespace {

constexpr std::size_t kLengthOffset = 4;

/// The field for the section; null if this version does not know its kind and codec.
std::span<const std::uint8_t>* place_of(std::uint8_t kind, std::uint8_t codec,
                                        PayloadSections& sections) {
  if (kind == static_cast<std::uint8_t>(SectionKind::kDepth) &&
      (codec == kLosslessDepth || codec == kLiveDepth || codec == kNearLosslessDepth)) {
    sections.depth_codec = codec;
    return &sections.depth;
  }
  if (kind == static_cast<std::uint8_t>(SectionKind::kColor) && codec == kVp9Color) {
    return &sections.color;
  }
  if (kind == static_cast<std::uint8_t>(SectionKind::kColorMask) &&
      (codec == kIntraMask || codec == kMaskChange)) {
    sections.mask_codec = codec;
    return &sections.color_mask;
  }
  return nullptr;
}

}  // namespace

Result<PayloadSections> parse_sections(std::span<const std::uint8_t> payload, int width,
                                       int height) {
  if (payload.size() > max_payload_length(width, height)) {
    return Error{ErrorCode::kTooLarge, "The frame is longer than any picture of its size can be."};
  }
  PayloadSections sections;
  std::uint32_t kinds = 0;  // bit k: kind k was present
  while (!payload.empty()) {
    if (payload.size() < kSectionHeaderLength) {
      return malformed("The frame ends within a section's header.");
    }
    const std::uint8_t kind = payload[0];
    const std::uint32_t length = read_u32(payload.data() + kLengthOffset);
    auto* const place = place_of(kind, payload[1], sections);
    if (place == nullptr) {
      return Error{ErrorCode::kUnsupported,
                   "The frame has a section of another version; update this program."};
    }
    payload = payload.subspan(kSectionHeaderLength);
    if (length > payload.size()) {
      return malformed("The frame ends within a section.");
    }
    if (kinds >> kind != 0) {
      return malformed("The frame's sections are doubled or out of order.");
    }
    kinds |= 1u << kind;
    *place = payload.first(length);
    payload = payload.subspan(length);
  }
  constexpr std::uint32_t kDepthAlone = 1u << 1, kDepthAndColor = 1u << 1 | 1u << 2 | 1u << 3;
  if (kinds != kDepthAlone && kinds != kDepthAndColor) {
    return malformed(
        "The frame lacks depth, or has one of colour and colour mask without the other.");
  }
  sections.has_color = kinds == kDepthAndColor;
  return sections;
}

std::size_t begin_section(SectionKind kind, std::uint8_t codec, std::vector<std::uint8_t>& out) {
  const std::size_t begin = out.size();
  out.resize(begin + kSectionHeaderLength, 0);
  out[begin] = static_cast<std::uint8_t>(kind);
  out[begin + 1] = codec;
  return begin;
}

void end_section(std::size_t begin, std::vector<std::uint8_t>& out) {
  const std::size_t length = out.size() - begin - kSectionHeaderLength;
  write_u32(&out[begin + kLengthOffset], static_cast<std::uint32_t>(length));
}

}  // namespace roomcast::codec
