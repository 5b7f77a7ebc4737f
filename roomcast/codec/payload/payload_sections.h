// SPDX-License-Identifier: Apache-2.0
// Finds, checks and writes the sections of a payload. docs/spec/codec.md §1.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::codec {

enum class SectionKind : std::uint8_t { kDepth = 1, kColor = 2, kColorMask = 3 };

inline constexpr std::uint8_t kLosslessDepth = 1, kLiveDepth = 2, kNearLosslessDepth = 3;
inline constexpr std::uint8_t kVp9Color = 1;
inline constexpr std::uint8_t kIntraMask = 1, kMaskChange = 2;

inline constexpr std::size_t kSectionHeaderLength = 8;
inline constexpr int kMinGridSide = 16, kMaxGridSide = 4096;
/// Whether a depth grid may be so many pixels wide or high.
[[nodiscard]] constexpr bool is_grid_side(int pixels) {
  return pixels >= kMinGridSide && pixels <= kMaxGridSide;
}
/// Maximum number of colour pixels for each depth pixel, per direction. The colour picture is also
/// limited to the largest depth grid, which bounds a decoder's memory.
inline constexpr int kMaxColorScale = 2;
[[nodiscard]] constexpr bool is_color_size(int width, int height) {
  return width <= kMaxGridSide && height <= kMaxGridSide;
}

/// Longer payloads are refused. Depth of 16-bit noise takes 2.5 bytes a pixel.
[[nodiscard]] constexpr std::size_t max_payload_length(int width, int height) {
  return 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + 65536;
}

/// Bytes of each section within a payload; colour and its mask are both present or both absent.
struct PayloadSections {
  std::span<const std::uint8_t> depth;
  std::uint8_t depth_codec = kLosslessDepth;
  std::span<const std::uint8_t> color;
  std::span<const std::uint8_t> color_mask;
  std::uint8_t mask_codec = kIntraMask;
  bool has_color = false;
};

/// Returns kTooLarge, kMalformed, or kUnsupported for a kind or codec unknown to this version.
[[nodiscard]] Result<PayloadSections> parse_sections(std::span<const std::uint8_t> payload,
                                                     int width, int height);

/// Appends a section's header. The caller then appends the section's bytes and calls `end_section`.
[[nodiscard]] std::size_t begin_section(SectionKind kind, std::uint8_t codec,
                                        std::vector<std::uint8_t>& out);
/// `begin` as returned by begin_section.
void end_section(std::size_t begin, std::vector<std::uint8_t>& out);

}  // namespace roomcast::codec
