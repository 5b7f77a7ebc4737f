// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/lossless/lossless_depth_encoder.h"

#include "roomcast/codec/little_endian.h"
#include "roomcast/codec/lossless/depth_tokens.h"
#include "roomcast/codec/lossless/predictor_fitting.h"

namespace roomcast::codec {
namespace {

constexpr std::size_t kHeaderLength = 8;
constexpr std::uint32_t kStateLow = 1u << 16;

// A symbol: token, context, number of plain bits, the bits.
constexpr int kContextShift = 7, kExtraCountShift = 13, kExtraShift = 17;
constexpr std::uint32_t pack_symbol(int token, int context, int extra_bits, std::uint32_t extra) {
  return static_cast<std::uint32_t>(token | context << kContextShift |
                                    extra_bits << kExtraCountShift) |
         extra << kExtraShift;
}
static_assert(kTokenCount <= 1 << kContextShift);
static_assert(kContextCount <= 1 << (kExtraCountShift - kContextShift));

/// Range asymmetric numeral system, encoding side: writes words from the end of its memory towards
/// the front.
class WordWriter {
 public:
  explicit WordWriter(std::uint8_t* end) : next_(end) {}
  void put_bits(std::uint32_t bits, int count) {
    if (static_cast<std::uint64_t>(state_) >> (32 - count)) put_word();
    state_ = state_ << count | bits;
  }
  void put_token(std::uint32_t frequency, std::uint32_t start) {
    if (state_ >> 20 >= frequency) put_word();
    state_ = (state_ / frequency << kFrequencyBits) + state_ % frequency + start;
  }
  std::uint8_t* finish() {
    next_ -= 4;
    write_u32(next_, state_);
    return next_;
  }

 private:
  void put_word() {
    next_ -= 2;
    write_u16(next_, state_ & 0xFFFF);
    state_ >>= 16;
  }
  std::uint32_t state_ = kStateLow;
  std::uint8_t* next_;
};

/// Whether few enough distances occur that naming them by index pays.
bool worth_mapping(std::size_t count, std::size_t span) {
  return count > 0 && 2 * count < span;
}

}  // namespace

void LosslessDepthEncoder::encode(DepthView depth_mm, std::vector<std::uint8_t>& out) {
  map_values(depth_mm);
  const DepthView plane{plane_.data(), depth_mm.width, depth_mm.height, depth_mm.width};
  side_.predictors = fit_predictors(plane);

  const int top_height = (plane.height + 1) / 2;
  const std::size_t top_pixels =
      static_cast<std::size_t>(top_height) * static_cast<std::size_t>(plane.width);
  symbols_.resize(plane.pixel_count());
  for (TokenCounts& counts : counts_) counts.fill(0);
  tokenise(plane, 0, top_height);
  tokenise(plane, top_height, plane.height);
  merge_tables(counts_, side_);

  const std::size_t header = out.size();
  out.resize(header + kHeaderLength);
  put_side_information(side_, out);
  const std::size_t top = out.size();
  tables_.clear();
  for (const Weights& weights : side_.tables) tables_.push_back(normalised(weights));
  append_slice(0, top_pixels, out);
  const std::size_t bottom = out.size();
  append_slice(top_pixels, symbols_.size(), out);
  write_u32(&out[header], static_cast<std::uint32_t>(top - header - kHeaderLength));
  write_u32(&out[header + 4], static_cast<std::uint32_t>(bottom - top));
}

void LosslessDepthEncoder::map_values(DepthView depth_mm) {
  index_of_value_.assign(kDepthValueCount, 0);
  for (int y = 0; y < depth_mm.height; ++y) {
    const std::uint16_t* row = depth_mm.row(y);
    for (int x = 0; x < depth_mm.width; ++x) index_of_value_[row[x]] = 1;
  }
  side_.values.assign(1, 0);
  for (std::size_t value = 1; value < kDepthValueCount; ++value) {
    if (!index_of_value_[value]) continue;
    index_of_value_[value] = static_cast<std::uint16_t>(side_.values.size());
    side_.values.push_back(static_cast<std::uint16_t>(value));
  }
  index_of_value_[0] = 0;
  const std::size_t count = side_.values.size() - 1;
  side_.mapped = worth_mapping(count, count ? side_.values.back() - side_.values[1] + 1u : 0);
  plane_.resize(depth_mm.pixel_count());
  std::uint16_t* to = plane_.data();
  for (int y = 0; y < depth_mm.height; ++y, to += depth_mm.width) {
    const std::uint16_t* row = depth_mm.row(y);
    if (!side_.mapped) {
      std::copy(row, row + depth_mm.width, to);
    } else {
      for (int x = 0; x < depth_mm.width; ++x) to[x] = index_of_value_[row[x]];
    }
  }
}

void LosslessDepthEncoder::tokenise(DepthView plane, int first_row, int end_row) {
  rows_.restart(plane.width);
  Symbol* symbol = symbols_.data() + static_cast<std::ptrdiff_t>(first_row) * plane.width;
  for (int y = first_row; y < end_row; ++y) {
    rows_.advance();
    RowWalk walk(rows_);
    const std::uint16_t* row = plane.row(y);
    for (int x = 0; x < plane.width; ++x) {
      const auto error = static_cast<std::int16_t>(row[x] - walk.prediction(side_.predictors));
      const std::uint32_t folded = fold(error);
      const bool hole = row[x] == 0;
      const int token = hole ? kHoleToken : token_of(folded);
      const TokenMeaning meaning = kTokenMeanings[static_cast<std::size_t>(token)];
      const int context = walk.context();
      const std::uint32_t extra = hole ? 0 : folded - meaning.base;
      *symbol++ = pack_symbol(token, context, meaning.extra_bits, extra);
      ++counts_[static_cast<std::size_t>(context)][static_cast<std::size_t>(token)];
      const auto magnitude =
          static_cast<std::uint8_t>(std::min(std::abs(int{error}), kLargestMagnitude));
      walk.take(hole ? walk.hole() : Cell{row[x], magnitude, 1});
    }
    walk.end();
  }
}

void LosslessDepthEncoder::append_slice(std::size_t first_symbol, std::size_t end_symbol,
                                        std::vector<std::uint8_t>& out) {
  words_.resize(4 * (end_symbol - first_symbol) + 4);
  std::uint8_t* const end = words_.data() + words_.size();
  WordWriter writer(end);
  for (std::size_t i = end_symbol; i-- > first_symbol;) {
    const Symbol symbol = symbols_[i];
    const auto token = symbol & ((1u << kContextShift) - 1);
    const auto context = symbol >> kContextShift & ((1u << (kExtraCountShift - kContextShift)) - 1);
    const int extra_bits = symbol >> kExtraCountShift & 15;
    if (extra_bits) writer.put_bits(symbol >> kExtraShift, extra_bits);
    const FrequencyTable& table = tables_[side_.table_of_context[context]];
    writer.put_token(table.frequency[token], table.start[token]);
  }
  out.insert(out.end(), writer.finish(), end);
}

}  // namespace roomcast::codec
