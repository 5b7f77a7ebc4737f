// SPDX-License-Identifier: Apache-2.0
// What `roomcast doctor` finds about the network of this computer. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "roomcast/doctor/finding.h"

namespace roomcast::doctor {

/// Whether a hub can listen at this port of every address.
[[nodiscard]] Finding check_port(std::uint16_t port);

/// `addresses`: of this computer, without loopback. Others reach a hub here at one of them.
[[nodiscard]] Finding judge_addresses(const std::vector<std::string>& addresses);
[[nodiscard]] Finding check_addresses();

}  // namespace roomcast::doctor
