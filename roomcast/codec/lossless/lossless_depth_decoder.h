// SPDX-License-Identifier: Apache-2.0
// Decodes depth sections of codec 1 (lossless) and codec 3 (near-lossless), each frame by itself.
// docs/spec/codec.md §2.1 to §2.3. Accepts hostile bytes: memory and work depend on the picture's
// size only. Integer only, the same bits everywhere.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/codec/lossless/side_information.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::codec {

/// Keeps its memory from frame to frame.
class LosslessDepthDecoder {
 public:
  /// Fills `depth_mm`, whose size must be that of the sensor. kMalformed unless `section` is one
  /// whole depth section; `depth_mm` is then partly filled.
  [[nodiscard]] Status decode(std::span<const std::uint8_t> section,
                              ImageView<std::uint16_t> depth_mm);

  /// The same for a section of codec 3.
  [[nodiscard]] Status decode_near_lossless(std::span<const std::uint8_t> section,
                                            ImageView<std::uint16_t> depth_mm);

 private:
  struct Slice;
  struct Slices {
    std::span<const std::uint8_t> top, bottom;
  };
  [[nodiscard]] Result<Slices> read_side_information(std::span<const std::uint8_t> section);
  void build_lookup();
  template <class Residual>
  [[nodiscard]] Status decode_slices(const Slices& slices, const Residual& residual,
                                     ImageView<std::uint16_t> depth);
  [[nodiscard]] Status values_from_indices(ImageView<std::uint16_t> depth) const;

  SideInformation side_;
  std::vector<std::uint32_t> lookup_;  // kFrequencySum entries for each table
  std::vector<std::uint8_t> padded_top_, padded_bottom_;
  CellRows top_rows_, bottom_rows_;
};

}  // namespace roomcast::codec
