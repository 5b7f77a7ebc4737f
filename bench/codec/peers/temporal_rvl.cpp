// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/peers/temporal_rvl.h"

#include <cstdlib>

#include "bench/codec/peers/rvl.h"

namespace roomcast::bench {
namespace {

constexpr int kTimesInvalid = 2;

}  // namespace

TemporalRvlEncoder::TemporalRvlEncoder(std::size_t pixel_count, int threshold_mm)
    : threshold_mm_(threshold_mm),
      kept_mm_(pixel_count),
      times_invalid_(pixel_count),
      differences_(pixel_count) {}

void TemporalRvlEncoder::encode(std::span<const std::uint16_t> depth_mm, bool key,
                                std::vector<std::uint8_t>& out) {
  if (key) {
    kept_mm_.assign(depth_mm.begin(), depth_mm.end());
    encode_rvl(std::span<const std::uint16_t>(kept_mm_), out);
    return;
  }
  update(depth_mm);
  encode_rvl(std::span<const std::int16_t>(differences_), out);
}

void TemporalRvlEncoder::update(std::span<const std::uint16_t> depth_mm) {
  for (std::size_t i = 0; i < depth_mm.size(); ++i) {
    const int before = kept_mm_[i], now = depth_mm[i];
    times_invalid_[i] = static_cast<std::uint8_t>(now == 0 ? times_invalid_[i] + 1 : 0);
    if (now == 0) {
      if (times_invalid_[i] >= kTimesInvalid) {
        kept_mm_[i] = 0;
        times_invalid_[i] = 0;
      }
    } else if (before == 0 || std::abs(now - before) > threshold_mm_) {
      kept_mm_[i] = depth_mm[i];
    }
    differences_[i] = static_cast<std::int16_t>(kept_mm_[i] - before);
  }
}

TemporalRvlDecoder::TemporalRvlDecoder(std::size_t pixel_count)
    : kept_mm_(pixel_count), differences_(pixel_count) {}

std::span<const std::uint16_t> TemporalRvlDecoder::decode(std::span<const std::uint8_t> bytes,
                                                          bool key) {
  if (key) {
    decode_rvl(bytes, std::span(kept_mm_));
    return kept_mm_;
  }
  decode_rvl(bytes, std::span(differences_));
  for (std::size_t i = 0; i < kept_mm_.size(); ++i) {
    kept_mm_[i] = static_cast<std::uint16_t>(kept_mm_[i] + differences_[i]);
  }
  return kept_mm_;
}

}  // namespace roomcast::bench
