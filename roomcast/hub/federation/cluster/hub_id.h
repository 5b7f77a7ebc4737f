// SPDX-License-Identifier: Apache-2.0
// HubId: one run of one hub. Made up when it starts, so that a hub that was killed and started
// again is another one.
#pragma once

#include <cstdint>
#include <string>

#include "roomcast/core/ids.h"

namespace roomcast::hub::federation {

using HubId = Id<struct HubTag, std::uint64_t>;

/// Not zero, and nobody else's.
[[nodiscard]] HubId new_hub_id();
/// 16 hexadecimal digits.
[[nodiscard]] std::string to_string(HubId hub);

}  // namespace roomcast::hub::federation
