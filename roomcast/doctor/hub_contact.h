// SPDX-License-Identifier: Apache-2.0
// Whether a hub can be reached from this computer, and how far away it is. Nothing is joined, so no
// token is needed. Thread-safe (no state).
#pragma once

#include <string>

#include "roomcast/doctor/finding.h"

namespace roomcast::doctor {

/// Connects as every client does (name, TCP, TLS, WebSocket), and measures the shortest of a few
/// round trips. Takes at most some seconds. `url`: as for --hub; of several, the first.
[[nodiscard]] Finding check_hub(const std::string& url);

}  // namespace roomcast::doctor
