// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/vp9_header.h"

namespace roomcast::codec {
namespace {

constexpr std::uint32_t kFrameMarker = 2;
constexpr std::uint32_t kSyncCode = 0x498342;
constexpr std::uint32_t kColorSpaceRgb = 7;
constexpr int kReferencesPerFrame = 3;

/// Reads bits, highest first. Past the end it reads zeros, and `overran` is true.
class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t take(int count) {
    std::uint32_t value = 0;
    for (; count > 0; --count, ++position_) {
      const std::size_t byte = position_ / 8;
      const std::uint32_t bit =
          byte < bytes_.size() ? bytes_[byte] >> (7 - position_ % 8) & 1u : 0u;
      value = value << 1 | bit;
    }
    return value;
  }
  [[nodiscard]] bool overran() const { return position_ > bytes_.size() * 8; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t position_ = 0;
};

void take_size(BitReader& bits, Vp9Header& header) {
  header.width = static_cast<int>(bits.take(16)) + 1;
  header.height = static_cast<int>(bits.take(16)) + 1;
}

/// Returns false if it is not the start of a key frame of profile 0.
bool take_key_start(BitReader& bits, Vp9Header& header) {
  if (bits.take(24) != kSyncCode) return false;
  if (bits.take(3) == kColorSpaceRgb) return false;
  bits.take(1);  // color_range
  take_size(bits, header);
  return true;
}

void take_size_or_reference(BitReader& bits, Vp9Header& header) {
  for (int i = 0; i < kReferencesPerFrame; ++i) {
    if (bits.take(1)) return;
  }
  take_size(bits, header);
}

void take_inter_start(BitReader& bits, bool error_resilient, Vp9Header& header) {
  if (!error_resilient) bits.take(2);  // reset_frame_context
  bits.take(8);                        // refresh_frame_flags
  bits.take(4 * kReferencesPerFrame);  // ref_frame_idx and sign_bias
  take_size_or_reference(bits, header);
}

}  // namespace

Result<Vp9Header> parse_vp9_header(std::span<const std::uint8_t> frame) {
  BitReader bits(frame);
  if (bits.take(2) != kFrameMarker) {
    return malformed("The colour section is not a VP9 frame.");
  }
  const std::uint32_t profile = bits.take(2);
  const bool repeats_earlier = bits.take(1) != 0;
  Vp9Header header;
  header.key = bits.take(1) == 0;
  const bool shown = bits.take(1) != 0;
  const bool error_resilient = bits.take(1) != 0;
  if (profile != 0 || repeats_earlier || !shown) {
    return Error{ErrorCode::kUnsupported,
                 "The colour section holds a kind of VP9 frame that roomcast does not use."};
  }
  if (header.key && !take_key_start(bits, header)) {
    return malformed("The colour section's VP9 key frame is damaged.");
  }
  if (!header.key) take_inter_start(bits, error_resilient, header);
  if (bits.overran()) {
    return malformed("The colour section's VP9 frame is cut short.");
  }
  return header;
}

}  // namespace roomcast::codec
