// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/lossless/lossless_depth_encoder.h"

#include "roomcast/codec/lossless/depth_tokens.h"
#include "roomcast/codec/lossless/predictor_fitting.h"
#include "roomcast/codec/lossless/residual.h"
#include "roomcast/core/little_endian.h"

namespace roomcast::codec {
namespace {

constexpr std::size_t kHeaderLength = 8;
constexpr std::uint32_t kStateLow = 1u << 16;
// At most two words per symbol: one before its token, one before its plain bits.
constexpr std::size_t kMaxBytesPerSymbol = 4;

// Bits of a symbol, from the lowest: token, context, number of plain bits, plain bits.
constexpr int kContextShift = 7, kExtraCountShift = 13, kExtraShift = 17;
constexpr std::uint32_t pack_symbol(int token, int context, int extra_bits, std::uint32_t extra) {
  return static_cast<std::uint32_t>(token | context << kContextShift |
                                    extra_bits << kExtraCountShift) |
         extra << kExtraShift;
}
static_assert(kTokenCount <= 1 << kContextShift);
static_assert(kContextCount <= 1 << (kExtraCountShift - kContextShift));

/// Does not reallocate an image that already has the size.
void make_size(DepthImage& image, int width, int height) {
  if (image.width() != width || image.height() != height) image.resize(width, height);
}

/// Copies without the gaps between rows.
void copy_rows(DepthView from, DepthImage& to) {
  for (int y = 0; y < from.height; ++y) std::copy_n(from.row(y), from.width, to.view().row(y));
}

constexpr int kReciprocalBits = 44;

/// state / frequency without a division. Exact, and without overflow, for state < frequency * 2^20
/// and frequency <= 2^12: the reciprocal is too large by less than 1, hence the quotient by less
/// than frequency / 2^24, which is at most 1 / frequency.
std::uint32_t divided(std::uint32_t state, const TokenCode& code) {
  return static_cast<std::uint32_t>(state * code.reciprocal >> kReciprocalBits);
}

/// Range asymmetric numeral system, encoding side: writes words from the end of its memory towards
/// the front.
class WordWriter {
 public:
  explicit WordWriter(std::vector<std::uint8_t>& memory) : next_(memory.data() + memory.size()) {}
  void put_bits(std::uint32_t bits, int count) {
    if (static_cast<std::uint64_t>(state_) >> (32 - count)) put_word();
    state_ = state_ << count | bits;
  }
  void put_token(const TokenCode& code) {
    if (state_ >> 20 >= code.frequency) put_word();
    const std::uint32_t quotient = divided(state_, code);
    state_ = (quotient << kFrequencyBits) + state_ - quotient * code.frequency + code.start;
  }
  std::uint8_t* finish() {
    next_ -= 4;
    write_u32(next_, state_);
    return next_;
  }

 private:
  void put_word() {
    next_ -= 2;
    write_u16(next_, static_cast<std::uint16_t>(state_));
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
  build_codes();
  const std::size_t top_length = append_slices(top_pixels, out);
  write_u32(&out[header], static_cast<std::uint32_t>(top - header - kHeaderLength));
  write_u32(&out[header + 4], static_cast<std::uint32_t>(top_length));
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
      const int token = hole ? kHoleToken : quick_token_of(folded);
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

void LosslessDepthEncoder::build_codes() {
  codes_.resize(side_.tables.size());
  for (std::size_t i = 0; i < codes_.size(); ++i) {
    const FrequencyTable table = normalised(side_.tables[i]);
    for (std::size_t token = 0; token < kTokenCount; ++token) {
      const std::uint32_t frequency = table.frequency[token];
      if (frequency == 0) continue;
      constexpr std::uint64_t kOne = std::uint64_t{1} << kReciprocalBits;
      codes_[i][token] = {(kOne + frequency - 1) / frequency, frequency, table.start[token]};
    }
  }
}

std::size_t LosslessDepthEncoder::append_slices(std::size_t top_pixels,
                                                std::vector<std::uint8_t>& out) {
  const std::size_t bottom_pixels = symbols_.size() - top_pixels;
  top_words_.resize(kMaxBytesPerSymbol * top_pixels + 4);
  bottom_words_.resize(kMaxBytesPerSymbol * bottom_pixels + 4);
  std::array<const TokenCode*, kContextCount> codes;
  for (std::size_t c = 0; c < kContextCount; ++c)
    codes[c] = codes_[side_.table_of_context[c]].data();
  const auto put = [&codes](WordWriter& writer, Symbol symbol) {
    const auto token = symbol & ((1u << kContextShift) - 1);
    const auto context = symbol >> kContextShift & ((1u << (kExtraCountShift - kContextShift)) - 1);
    const int extra_bits = symbol >> kExtraCountShift & 15;
    if (extra_bits) writer.put_bits(symbol >> kExtraShift, extra_bits);
    writer.put_token(codes[context][token]);
  };
  // Alternating between the slices hides the latency of each state update.
  WordWriter top(top_words_), bottom(bottom_words_);
  const Symbol *next_top = symbols_.data() + top_pixels,
               *next_bottom = symbols_.data() + symbols_.size();
  for (std::size_t i = 0; i < bottom_pixels; ++i) {
    put(top, *--next_top);
    put(bottom, *--next_bottom);
  }
  while (next_top != symbols_.data()) put(top, *--next_top);
  const std::size_t begin = out.size();
  out.insert(out.end(), top.finish(), top_words_.data() + top_words_.size());
  const std::size_t top_length = out.size() - begin;
  out.insert(out.end(), bottom.finish(), bottom_words_.data() + bottom_words_.size());
  return top_length;
}

}  // namespace roomcast::codec
