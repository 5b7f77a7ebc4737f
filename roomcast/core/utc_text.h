// SPDX-License-Identifier: Apache-2.0
// Dates for people and files: ISO 8601, UTC. Thread-safe (no state).
#pragma once

#include <optional>
#include <string>

#include "roomcast/core/clock.h"

namespace roomcast {

/// "2026-11-26T12:00:00.123456789Z". `unix_time`: since 1970-01-01 UTC, not negative.
[[nodiscard]] std::string utc_text(nanoseconds unix_time);

/// Of such a text, with any number of digits of a second, or none. Nothing: it is something else.
[[nodiscard]] std::optional<nanoseconds> read_utc_text(const std::string& text);

}  // namespace roomcast
