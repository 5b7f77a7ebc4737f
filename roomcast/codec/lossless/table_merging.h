// SPDX-License-Identifier: Apache-2.0
// Merges the frequency tables of adjacent contexts if separate tables cost more bits than they
// save.
#pragma once

#include <array>
#include <cstdint>

#include "roomcast/codec/lossless/side_information.h"

namespace roomcast::codec {

using TokenCounts = std::array<std::uint32_t, kTokenCount>;

/// Fills `tables` and `table_of_context` of `side`. At least one count must not be 0.
void merge_tables(const std::array<TokenCounts, kContextCount>& counts, SideInformation& side);

}  // namespace roomcast::codec
