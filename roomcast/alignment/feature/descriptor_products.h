// SPDX-License-Identifier: Apache-2.0
// Dot products of one descriptor with many: the inner loop of matching. The arithmetic is integer,
// so every processor gives the same results. AVX-512 VNNI or AVX2 is used where available.
// Thread-safe (no state).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "roomcast/alignment/feature/feature_set.h"

namespace roomcast::alignment {

/// Descriptors that fit into the first-level cache: compare a whole set with one tile of another at
/// a time.
inline constexpr std::size_t kDescriptorTile = 96;

/// `products[i]` = `descriptor` . `others[i]`; `products` is at least as long as `others`.
void descriptor_products(const Descriptor& descriptor, std::span<const Descriptor> others,
                         std::span<std::int32_t> products);

/// Plain implementation: the fallback, and the reference in tests.
void descriptor_products_reference(const Descriptor& descriptor, std::span<const Descriptor> others,
                                   std::span<std::int32_t> products);

}  // namespace roomcast::alignment
