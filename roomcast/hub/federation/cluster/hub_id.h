// SPDX-License-Identifier: Apache-2.0
// HubId: one run of one hub. Chosen at random at the start, so that a restarted hub has a new one.
#pragma once

#include <cstdint>
#include <string>

#include "roomcast/core/ids.h"

namespace roomcast::hub::federation {

using HubId = Id<struct HubTag, std::uint64_t>;

/// Random, not zero.
[[nodiscard]] HubId new_hub_id();
/// 16 hexadecimal digits.
[[nodiscard]] std::string to_string(HubId hub);

}  // namespace roomcast::hub::federation
