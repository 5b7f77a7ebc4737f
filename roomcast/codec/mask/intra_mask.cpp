// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/mask/intra_mask.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "roomcast/codec/entropy/binary_arithmetic_code.h"
#include "roomcast/codec/payload/payload_sections.h"
#include "roomcast/core/assert.h"

namespace roomcast::codec {
namespace {

constexpr int kGroupWidth = 16;
constexpr int kEdgeShare = 32;  // depths that differ by more than 1/32 are on different surfaces

/// Visits the mask in coding order. `Coder` provides each bit: the encoder from the picture, the
/// decoder from the bytes. The mask is filled in as the contexts use it: a pixel without a reading
/// copies the row above.
template <class Coder>
class MaskWalk {
 public:
  MaskWalk(Coder& coder, DepthView depth) : coder_(coder), depth_(depth) {
    ROOMCAST_ASSERT(depth.width <= kMaxGridSide);
    for (Row& row : rows_) row.fill(1);
  }

  /// Fills `known` with 0 and 1.
  void run(ImageView<std::uint8_t> known) {
    for (int y = 0; y < depth_.height; ++y) {
      std::uint8_t* const above = rows_[(y + 1) % 2].data() + 1;
      std::uint8_t* const row = rows_[y % 2].data() + 1;
      row[-1] = above[0];
      above[depth_.width] = above[depth_.width - 1];
      for (int x = 0; x < depth_.width; x += kGroupWidth) {
        code_group(y, x, std::min(x + kGroupWidth, depth_.width), above, row);
      }
      std::copy_n(row, depth_.width, known.row(y));
    }
  }

 private:
  using Row = std::array<std::uint8_t, kMaxGridSide + 2>;

  void code_group(int y, int begin, int end, const std::uint8_t* above, std::uint8_t* row) {
    const std::uint16_t* depth = depth_.row(y);
    const std::uint8_t left = row[begin - 1];
    bool any = false, calm = true;
    for (int x = begin; x < end; ++x) {
      any |= depth[x] != 0;
      calm &= above[x] == left;
    }
    if (!any) {
      std::copy(above + begin, above + end, row + begin);
      return;
    }
    if (!coder_.group_varies(group_bits_[calm], y, begin, end, left)) {
      for (int x = begin; x < end; ++x) row[x] = depth[x] ? left : above[x];
      return;
    }
    for (int x = begin; x < end; ++x) {
      row[x] = depth[x] ? coder_.pixel(pixel_bits_[context(y, x, above, row)], y, x) : above[x];
    }
  }

  [[nodiscard]] std::size_t context(int y, int x, const std::uint8_t* above,
                                    const std::uint8_t* row) const {
    const std::uint16_t* depth = depth_.row(y);
    const bool edge_w = x == 0 || is_edge(depth[x], depth[x - 1]);
    const bool edge_n = y == 0 || is_edge(depth[x], depth_.at(x, y - 1));
    return static_cast<std::size_t>(row[x - 1] | above[x - 1] << 1 | above[x] << 2 |
                                    above[x + 1] << 3 | edge_w << 4 | edge_n << 5);
  }
  static bool is_edge(int d, int other) {
    return other == 0 || kEdgeShare * std::abs(d - other) > d;
  }

  Coder& coder_;
  DepthView depth_;
  std::array<AdaptiveBit, 2> group_bits_;
  std::array<AdaptiveBit, 64> pixel_bits_;
  std::array<Row, 2> rows_;
};

struct MaskWriter {
  ArithmeticEncoder encoder;
  MaskView mask;
  DepthView depth;

  bool group_varies(AdaptiveBit& bit, int y, int begin, int end, std::uint8_t left) {
    bool varies = false;
    for (int x = begin; x < end; ++x) {
      varies |= depth.at(x, y) != 0 && (mask.at(x, y) != 0) != (left != 0);
    }
    encoder.put(bit, varies);
    return varies;
  }
  std::uint8_t pixel(AdaptiveBit& bit, int y, int x) {
    const bool seen = mask.at(x, y) != 0;
    encoder.put(bit, seen);
    return seen;
  }
};

struct MaskReader {
  ArithmeticDecoder decoder;

  bool group_varies(AdaptiveBit& bit, int, int, int, std::uint8_t) { return decoder.get(bit); }
  std::uint8_t pixel(AdaptiveBit& bit, int, int) { return decoder.get(bit); }
};

}  // namespace

void encode_intra_mask(MaskView mask, DepthView depth_mm, ImageView<std::uint8_t> known,
                       std::vector<std::uint8_t>& out) {
  MaskWriter writer{ArithmeticEncoder(out), mask, depth_mm};
  MaskWalk<MaskWriter>(writer, depth_mm).run(known);
  writer.encoder.finish();
}

void decode_intra_mask(std::span<const std::uint8_t> section, DepthView depth_mm,
                       ImageView<std::uint8_t> known) {
  MaskReader reader{ArithmeticDecoder(section)};
  MaskWalk<MaskReader>(reader, depth_mm).run(known);
}

}  // namespace roomcast::codec
