// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/lossless/lossless_depth_decoder.h"

#include <algorithm>
#include <cstring>

#include "roomcast/codec/lossless/depth_tokens.h"
#include "roomcast/codec/lossless/residual.h"
#include "roomcast/core/little_endian.h"

namespace roomcast::codec {
namespace {

constexpr std::size_t kHeaderLength = 8;
constexpr std::uint32_t kStateLow = 1u << 16;
// A pixel takes at most two words (one after its token, one after its plain bits).
constexpr std::size_t kMaxBytesPerPixel = 4;

/// One slot of a table: token, frequency - 1 and slot - start packed in one word: one load instead
/// of three.
constexpr std::uint32_t pack_slot(std::uint32_t token, std::uint32_t frequency,
                                  std::uint32_t offset) {
  return token | (frequency - 1) << 8 | offset << 20;
}

/// Range asymmetric numeral system, decoding side. The bytes must be followed by enough zeros for a
/// whole row.
class WordReader {
 public:
  WordReader(const std::uint8_t* begin, std::size_t length)
      : next_(begin + 4), end_(begin + length) {
    state_ = read_u32(begin);
  }
  [[nodiscard]] std::uint32_t take_token(const std::uint32_t* table) {
    const std::uint32_t slot = table[state_ & (kFrequencySum - 1)];
    state_ = ((slot >> 8 & 0xFFF) + 1) * (state_ >> kFrequencyBits) + (slot >> 20);
    refill();
    return slot & 0xFF;
  }
  [[nodiscard]] std::uint32_t take_bits(int count) {
    const std::uint32_t bits = state_ & ((1u << count) - 1);
    state_ >>= count;
    refill();
    return bits;
  }
  [[nodiscard]] bool overran() const { return next_ > end_; }
  [[nodiscard]] bool ended_well() const { return next_ == end_ && state_ == kStateLow; }

 private:
  // Branch-free, because it is unpredictable whether a word is due.
  void refill() {
    const std::uint32_t grown = state_ << 16 | read_u16(next_);
    const bool due = state_ < kStateLow;
    state_ = due ? grown : state_;
    next_ += due ? 2 : 0;
  }
  std::uint32_t state_;
  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

/// Copies the bytes with zeros for one row of reading past the end.
std::size_t padded_copy(std::span<const std::uint8_t> bytes, int width,
                        std::vector<std::uint8_t>& out) {
  const std::size_t length = std::max<std::size_t>(4, bytes.size());
  out.assign(length + kMaxBytesPerPixel * static_cast<std::size_t>(width) + 2, 0);
  if (!bytes.empty()) std::memcpy(out.data(), bytes.data(), bytes.size());
  return length;
}

}  // namespace

struct LosslessDepthDecoder::Slice {
  WordReader words;
  CellRows& rows;
  std::uint16_t* out = nullptr;

  // Inlined twice into one loop, so that the processor decodes both slices in parallel.
  template <class Residual>
  [[gnu::always_inline]] void decode_pixel(RowWalk& walk, const SideInformation& side,
                                           const Residual& residual,
                                           const std::uint32_t* const* tables) {
    const std::uint32_t token = words.take_token(tables[walk.context()]);
    const TokenMeaning meaning = kTokenMeanings[token & 127];
    const std::uint32_t folded = meaning.base + words.take_bits(meaning.extra_bits);
    const std::int32_t error = unfold(folded);
    const std::uint16_t value = residual.value(walk.prediction(side.predictors), error);
    const auto magnitude = static_cast<std::uint8_t>(std::min(std::abs(error), kLargestMagnitude));
    const bool hole = token == kHoleToken;
    *out++ = hole ? 0 : value;
    walk.take(hole ? walk.hole() : Cell{value, magnitude, 1});
  }
};

Status LosslessDepthDecoder::decode(std::span<const std::uint8_t> section,
                                    ImageView<std::uint16_t> depth_mm) {
  const auto slices = read_side_information(section);
  if (!slices.ok()) return slices.error();
  if (Status s = decode_slices(*slices, ExactResidual{}, depth_mm); !s.ok()) return s;
  return side_.mapped ? values_from_indices(depth_mm) : Status();
}

Status LosslessDepthDecoder::decode_near_lossless(std::span<const std::uint8_t> section,
                                                  ImageView<std::uint16_t> depth_mm) {
  if (section.empty()) return malformed("The depth section is cut short.");
  const int bound = section[0];
  if (bound == 0) return decode(section.subspan(1), depth_mm);
  if (bound > kMaxBound_mm) return malformed("The depth section's bound is beyond 63.");
  const auto slices = read_side_information(section.subspan(1));
  if (!slices.ok()) return slices.error();
  if (side_.mapped) return malformed("The depth section has both a bound and a value table.");
  return decode_slices(*slices, BoundedResidual(bound), depth_mm);
}

Result<LosslessDepthDecoder::Slices> LosslessDepthDecoder::read_side_information(
    std::span<const std::uint8_t> section) {
  if (section.size() < kHeaderLength) return malformed("The depth section is cut short.");
  const std::size_t side_length = read_u32(section.data());
  const std::size_t top_length = read_u32(section.data() + 4);
  const std::span<const std::uint8_t> body = section.subspan(kHeaderLength);
  if (side_length > body.size() || top_length > body.size() - side_length) {
    return malformed("The lengths in the depth section do not add up.");
  }
  if (Status s = get_side_information(body.first(side_length), side_); !s.ok()) return s.error();
  build_lookup();
  const auto slices = body.subspan(side_length);
  return Slices{slices.first(top_length), slices.subspan(top_length)};
}

void LosslessDepthDecoder::build_lookup() {
  lookup_.resize(side_.tables.size() * kFrequencySum);
  std::uint32_t* slot = lookup_.data();
  for (const Weights& weights : side_.tables) {
    const FrequencyTable table = normalised(weights);
    for (std::uint32_t token = 0; token < kTokenCount; ++token) {
      for (std::uint32_t i = 0; i < table.frequency[token]; ++i) {
        *slot++ = pack_slot(token, table.frequency[token], i);
      }
    }
  }
}

template <class Residual>
Status LosslessDepthDecoder::decode_slices(const Slices& slices, const Residual& residual,
                                           ImageView<std::uint16_t> depth) {
  const std::size_t top_length = padded_copy(slices.top, depth.width, padded_top_);
  const std::size_t bottom_length = padded_copy(slices.bottom, depth.width, padded_bottom_);
  top_rows_.restart(depth.width);
  bottom_rows_.restart(depth.width);
  std::array<const std::uint32_t*, kContextCount> tables;
  for (int c = 0; c < kContextCount; ++c) {
    tables[c] = lookup_.data() + side_.table_of_context[c] * kFrequencySum;
  }
  Slice upper{WordReader(padded_top_.data(), top_length), top_rows_};
  Slice lower{WordReader(padded_bottom_.data(), bottom_length), bottom_rows_};
  const int top_height = (depth.height + 1) / 2, bottom_height = depth.height / 2;
  for (int y = 0; y < bottom_height; ++y) {
    upper.rows.advance();
    lower.rows.advance();
    upper.out = depth.row(y);
    lower.out = depth.row(top_height + y);
    RowWalk upper_walk(upper.rows), lower_walk(lower.rows);
    for (int x = 0; x < depth.width; ++x) {
      upper.decode_pixel(upper_walk, side_, residual, tables.data());
      lower.decode_pixel(lower_walk, side_, residual, tables.data());
    }
    upper_walk.end();
    lower_walk.end();
    if (upper.words.overran() || lower.words.overran())
      return malformed("The depth section ends early.");
  }
  if (top_height > bottom_height) {
    upper.rows.advance();
    upper.out = depth.row(bottom_height);
    RowWalk walk(upper.rows);
    for (int x = 0; x < depth.width; ++x) upper.decode_pixel(walk, side_, residual, tables.data());
    walk.end();
  }
  if (!upper.words.ended_well() || !lower.words.ended_well()) {
    return malformed("The depth section is damaged: its pixels do not end where its bytes do.");
  }
  return {};
}

Status LosslessDepthDecoder::values_from_indices(ImageView<std::uint16_t> depth) const {
  for (int y = 0; y < depth.height; ++y) {
    std::uint16_t* row = depth.row(y);
    for (int x = 0; x < depth.width; ++x) {
      if (row[x] >= side_.values.size()) {
        return malformed("The depth section points past its value table.");
      }
      row[x] = side_.values[row[x]];
    }
  }
  return {};
}

}  // namespace roomcast::codec
