// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/lossless/lossless_depth_encoder.h"

#include "roomcast/codec/little_endian.h"
#include "roomcast/codec/lossless/depth_tokens.h"
#include "roomcast/codec/lossless/predictor_fitting.h"
#include "roomcast/codec/lossless/residual.h"

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

/// Keeps the memory of an image that already has the size.
void make_size(DepthImage& image, int width, int height) {
  if (image.width() != width || image.height() != height) image.resize(width, height);
}

/// Without the gaps between rows.
void copy_rows(DepthView from, DepthImage& to) {
  for (int y = 0; y < from.height; ++y) std::copy_n(from.row(y), from.width, to.view().row(y));
}

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

}  // namespace

void LosslessDepthEncoder::encode(DepthView depth_mm, std::vector<std::uint8_t>& out) {
  map_values(depth_mm, 0);
  encode_plane(ExactResidual{}, out);
}

void LosslessDepthEncoder::encode_near_lossless(DepthView depth_mm, int bound_mm,
                                                std::vector<std::uint8_t>& out) {
  map_values(depth_mm, bound_mm);
  out.push_back(static_cast<std::uint8_t>(side_.mapped ? 0 : bound_mm));
  if (!side_.mapped) {
    encode_plane(BoundedResidual(bound_mm), out);
    return;
  }
  encode_plane(ExactResidual{}, out);
  for (std::size_t i = 0; i < plane_.view().pixel_count(); ++i) {
    plane_.data()[i] = side_.values[plane_.data()[i]];
  }
}

void LosslessDepthEncoder::map_values(DepthView depth_mm, int bound_mm) {
  side_.mapped = values_.choose(depth_mm, bound_mm, side_.values);
  make_size(plane_, depth_mm.width, depth_mm.height);
  if (side_.mapped) {
    values_.map(depth_mm, plane_.view());
  } else {
    copy_rows(depth_mm, plane_);
  }
}

template <class Residual>
void LosslessDepthEncoder::encode_plane(const Residual& residual, std::vector<std::uint8_t>& out) {
  side_.predictors = fit_predictors(plane_);
  const int height = plane_.height(), top_height = (height + 1) / 2;
  const std::size_t top_pixels =
      static_cast<std::size_t>(top_height) * static_cast<std::size_t>(plane_.width());
  symbols_.resize(plane_.view().pixel_count());
  for (TokenCounts& counts : counts_) counts.fill(0);
  tokenise(residual, 0, top_height);
  tokenise(residual, top_height, height);
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

template <class Residual>
void LosslessDepthEncoder::tokenise(const Residual& residual, int first_row, int end_row) {
  const int width = plane_.width();
  rows_.restart(width);
  Symbol* symbol = symbols_.data() + static_cast<std::ptrdiff_t>(first_row) * width;
  for (int y = first_row; y < end_row; ++y) {
    rows_.advance();
    RowWalk walk(rows_);
    std::uint16_t* row = plane_.view().row(y);
    for (int x = 0; x < width; ++x) {
      const int prediction = walk.prediction(side_.predictors);
      const std::int16_t error = residual.error(row[x], prediction);
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
      const std::uint16_t decoded = hole ? std::uint16_t{0} : residual.value(prediction, error);
      row[x] = decoded;
      walk.take(hole ? walk.hole() : Cell{decoded, magnitude, 1});
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
