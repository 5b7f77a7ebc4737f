// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/mask/mask_change.h"

#include <algorithm>
#include <array>

#include "roomcast/codec/entropy/binary_arithmetic_code.h"
#include "roomcast/codec/payload/payload_sections.h"
#include "roomcast/core/assert.h"

namespace roomcast::codec {
namespace {

constexpr int kGroupSide = 8;

/// Visits groups of 8x8 pixels in raster order. `Coder` provides each bit: the encoder from the
/// picture, the decoder from the bytes.
template <class Coder>
class ChangeWalk {
 public:
  ChangeWalk(Coder& coder, DepthView depth, ImageView<std::uint8_t> known)
      : coder_(coder), depth_(depth), known_(known) {
    ROOMCAST_ASSERT(depth.width <= kMaxGridSide);
  }

  void run() {
    for (int y = 0; y < depth_.height; y += kGroupSide) {
      std::uint8_t left_changed = 0;
      for (int x = 0; x < depth_.width; x += kGroupSide) {
        std::uint8_t& changed = changed_above_[static_cast<std::size_t>(x / kGroupSide)];
        const Group group{x, y, std::min(x + kGroupSide, depth_.width),
                          std::min(y + kGroupSide, depth_.height)};
        if (has_reading(group)) {
          changed = coder_.group_changes(group_bits_[left_changed + 2u * changed], group);
          if (changed) code_pixels(group);
        } else {
          changed = 0;
        }
        left_changed = changed;
      }
    }
  }

  struct Group {
    int x0, y0, x1, y1;
  };

 private:
  [[nodiscard]] bool has_reading(const Group& group) const {
    for (int y = group.y0; y < group.y1; ++y) {
      const std::uint16_t* row = depth_.row(y);
      if (std::any_of(row + group.x0, row + group.x1, [](std::uint16_t d) { return d != 0; }))
        return true;
    }
    return false;
  }

  void code_pixels(const Group& group) {
    for (int y = group.y0; y < group.y1; ++y) {
      for (int x = group.x0; x < group.x1; ++x) {
        if (depth_.at(x, y) == 0) continue;
        known_.at(x, y) = coder_.pixel(pixel_bits_[context(x, y)], x, y);
      }
    }
  }

  /// Context of a pixel: its old value, the new values of its neighbours to the left and above, the
  /// old ones of those to the right and below.
  [[nodiscard]] std::size_t context(int x, int y) const {
    const std::uint8_t was = known_.at(x, y);
    const auto at = [&](int nx, int ny) {
      const bool inside = nx >= 0 && ny >= 0 && nx < depth_.width && ny < depth_.height;
      return static_cast<std::size_t>(inside ? known_.at(nx, ny) : was);
    };
    return was | at(x - 1, y) << 1 | at(x, y - 1) << 2 | at(x + 1, y) << 3 | at(x, y + 1) << 4 |
           at(x - 1, y - 1) << 5 | at(x + 1, y - 1) << 6;
  }

  Coder& coder_;
  DepthView depth_;
  ImageView<std::uint8_t> known_;
  std::array<AdaptiveBit, 4> group_bits_;
  std::array<AdaptiveBit, 128> pixel_bits_;
  std::array<std::uint8_t, kMaxGridSide / kGroupSide> changed_above_{};
};

struct ChangeWriter {
  ArithmeticEncoder encoder;
  MaskView mask;
  DepthView depth;
  ImageView<const std::uint8_t> known;

  template <class Group>
  bool group_changes(AdaptiveBit& bit, const Group& group) {
    bool changes = false;
    for (int y = group.y0; y < group.y1; ++y) {
      for (int x = group.x0; x < group.x1; ++x) {
        changes |= depth.at(x, y) != 0 && (mask.at(x, y) != 0) != (known.at(x, y) != 0);
      }
    }
    encoder.put(bit, changes);
    return changes;
  }
  bool pixel(AdaptiveBit& bit, int x, int y) {
    const bool seen = mask.at(x, y) != 0;
    encoder.put(bit, seen);
    return seen;
  }
};

struct ChangeReader {
  ArithmeticDecoder decoder;

  template <class Group>
  bool group_changes(AdaptiveBit& bit, const Group&) {
    return decoder.get(bit);
  }
  bool pixel(AdaptiveBit& bit, int, int) { return decoder.get(bit); }
};

}  // namespace

void encode_mask_change(MaskView mask, DepthView depth_mm, ImageView<std::uint8_t> known,
                        std::vector<std::uint8_t>& out) {
  ChangeWriter writer{ArithmeticEncoder(out), mask, depth_mm, known};
  ChangeWalk<ChangeWriter>(writer, depth_mm, known).run();
  writer.encoder.finish();
}

void decode_mask_change(std::span<const std::uint8_t> section, DepthView depth_mm,
                        ImageView<std::uint8_t> known) {
  ChangeReader reader{ArithmeticDecoder(section)};
  ChangeWalk<ChangeReader>(reader, depth_mm, known).run();
}

}  // namespace roomcast::codec
