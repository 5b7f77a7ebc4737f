// SPDX-License-Identifier: Apache-2.0
// Dot products of one descriptor with many: the inner loop of matching. In integers, so every
// processor gives the same numbers; with AVX-512 VNNI or AVX2 where the processor has it.
// Thread-safe (no state).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "roomcast/alignment/feature/feature_set.h"

namespace roomcast::alignment {

/// So many stay in the first-level cache: compare all of a set with one tile of another at a time.
inline constexpr std::size_t kDescriptorTile = 96;

/// `products[i]` = `descriptor` . `others[i]`; at least as many as there are others.
void descriptor_products(const Descriptor& descriptor, std::span<const Descriptor> others,
                         std::span<std::int32_t> products);

/// The same, written to be read; tests hold the other against it.
void descriptor_products_reference(const Descriptor& descriptor, std::span<const Descriptor> others,
                                   std::span<std::int32_t> products);

}  // namespace roomcast::alignment
