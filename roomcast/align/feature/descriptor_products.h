// SPDX-License-Identifier: Apache-2.0
// Dot products of one descriptor with many: the inner loop of matching. In integers, so every
// processor gives the same numbers; with AVX2 where the processor has it. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <span>

#include "roomcast/align/feature/feature_set.h"

namespace roomcast::align {

/// `products[i]` = `descriptor` . `others[i]`; as many as there are others.
void descriptor_products(const Descriptor& descriptor, std::span<const Descriptor> others,
                         std::span<std::int32_t> products);

/// The same, written to be read; tests hold the other against it.
void descriptor_products_reference(const Descriptor& descriptor, std::span<const Descriptor> others,
                                   std::span<std::int32_t> products);

}  // namespace roomcast::align
