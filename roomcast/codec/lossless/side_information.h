// SPDX-License-Identifier: Apache-2.0
// The side information of a lossless depth frame, coded before its pixels: value table, predictors,
// frequency tables. docs/spec/codec.md §2.1.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/codec/lossless/depth_model.h"
#include "roomcast/codec/lossless/frequency_table.h"
#include "roomcast/core/result.h"

namespace roomcast::codec {

inline constexpr std::size_t kDepthValueCount = 65536;

/// Reused from frame to frame.
struct SideInformation {
  bool mapped = false;                // pixels are indices into `values`
  std::vector<std::uint16_t> values;  // values[0] = 0, then ascending
  Predictors predictors;
  std::vector<Weights> tables;
  std::array<std::uint8_t, kContextCount> table_of_context{};
};

/// Appends to `out`. `tables` are used in order: context 0 uses table 0, each later context the
/// same table or the next.
void put_side_information(const SideInformation& side, std::vector<std::uint8_t>& out);

/// Returns kMalformed for values above 65535 or impossible tables. Never more than kContextCount
/// tables.
[[nodiscard]] Status get_side_information(std::span<const std::uint8_t> bytes,
                                          SideInformation& side);

}  // namespace roomcast::codec
