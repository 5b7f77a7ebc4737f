// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/lossless/side_information.h"

#include <algorithm>
#include <bit>

namespace roomcast::codec {
namespace {

constexpr int kValueCountBits = 16;
constexpr int kWeightBits = 8;
constexpr int kLongestGap = 16;  // bits

struct GapModel {
  std::array<BitTree<5>, 8> length;
  int previous_length = 0;
  BitTree<5>& tree() { return length[static_cast<std::size_t>(std::min(previous_length, 7))]; }
};

void put_gap(ArithmeticEncoder& encoder, GapModel& model, std::uint32_t gap) {
  const auto length = static_cast<int>(std::bit_width(gap));
  encoder.put(model.tree(), static_cast<std::uint32_t>(length));
  if (length > 1) encoder.put_raw(gap & ((1u << (length - 1)) - 1), length - 1);
  model.previous_length = length;
}

/// A gap of more than kLongestGap bits means malformed.
std::uint32_t get_gap(ArithmeticDecoder& decoder, GapModel& model) {
  const auto length = static_cast<int>(decoder.get(model.tree()));
  model.previous_length = length;
  if (length > kLongestGap) return kDepthValueCount;
  if (length < 2) return static_cast<std::uint32_t>(length);
  return 1u << (length - 1) | decoder.get_raw(length - 1);
}

void put_values(ArithmeticEncoder& encoder, const SideInformation& side) {
  encoder.put_raw(side.mapped, 1);
  if (!side.mapped) return;
  encoder.put_raw(static_cast<std::uint32_t>(side.values.size() - 1), kValueCountBits);
  GapModel model;
  for (std::size_t i = 1; i < side.values.size(); ++i) {
    put_gap(encoder, model, side.values[i] - side.values[i - 1] - 1u);
  }
}

Status get_values(ArithmeticDecoder& decoder, SideInformation& side) {
  side.values.assign(1, 0);
  side.mapped = decoder.get_raw(1) != 0;
  if (!side.mapped) return {};
  const std::uint32_t count = decoder.get_raw(kValueCountBits);
  if (count == 0) return malformed("The depth section's value table is empty.");
  GapModel model;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t value = side.values.back() + get_gap(decoder, model) + 1;
    if (value >= kDepthValueCount) {
      return malformed("The depth section's value table goes beyond 65535.");
    }
    side.values.push_back(static_cast<std::uint16_t>(value));
  }
  return {};
}

void put_predictors(ArithmeticEncoder& encoder, const Predictors& predictors) {
  for (int c = 0; c < kLinearClassCount; ++c) {
    encoder.put_raw(predictors[c].linear, 1);
    if (!predictors[c].linear) continue;
    for (const std::int8_t weight : predictors[c].weights) {
      encoder.put_raw(static_cast<std::uint8_t>(weight), kWeightBits);
    }
  }
}

void get_predictors(ArithmeticDecoder& decoder, Predictors& predictors) {
  predictors = {};
  for (int c = 0; c < kLinearClassCount; ++c) {
    predictors[c].linear = decoder.get_raw(1) != 0;
    if (!predictors[c].linear) continue;
    for (std::int8_t& weight : predictors[c].weights) {
      weight = static_cast<std::int8_t>(decoder.get_raw(kWeightBits));
    }
  }
}

}  // namespace

void put_side_information(const SideInformation& side, std::vector<std::uint8_t>& out) {
  ArithmeticEncoder encoder(out);
  put_values(encoder, side);
  put_predictors(encoder, side.predictors);
  WeightModel model;
  AdaptiveBit has_own_table;
  for (int c = 0; c < kContextCount; ++c) {
    const bool own = c == 0 || side.table_of_context[c] != side.table_of_context[c - 1];
    if (c > 0) encoder.put(has_own_table, own);
    if (own) put_weights(encoder, model, side.tables[side.table_of_context[c]]);
  }
  encoder.finish();
}

Status get_side_information(std::span<const std::uint8_t> bytes, SideInformation& side) {
  ArithmeticDecoder decoder(bytes);
  if (Status status = get_values(decoder, side); !status.ok()) return status;
  get_predictors(decoder, side.predictors);
  WeightModel model;
  AdaptiveBit has_own_table;
  side.tables.clear();
  for (int c = 0; c < kContextCount; ++c) {
    if (c == 0 || decoder.get(has_own_table)) {
      side.tables.emplace_back();
      if (!get_weights(decoder, model, side.tables.back())) {
        return malformed("The depth section has an impossible frequency table.");
      }
    }
    side.table_of_context[c] = static_cast<std::uint8_t>(side.tables.size() - 1);
  }
  return {};
}

}  // namespace roomcast::codec
