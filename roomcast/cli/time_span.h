// SPDX-License-Identifier: Apache-2.0
// Durations such as "90s", "30m", "8h", "7d". Thread-safe (no state).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "roomcast/core/result.h"

namespace roomcast::cli {

/// Seconds. kInvalidArgument: `text` is not a duration of this form, or is zero.
[[nodiscard]] Result<std::int64_t> parse_time_span(std::string_view text);

/// Uses the largest unit that fits at least twice, or exactly once, and rounds down: 90 s is "90s",
/// 7200 s is "2h".
[[nodiscard]] std::string format_time_span(std::int64_t seconds);

}  // namespace roomcast::cli
