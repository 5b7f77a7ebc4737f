// SPDX-License-Identifier: Apache-2.0
// "90s", "30m", "8h", "7d": how long something holds, as people write it. Threading: no state.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "roomcast/core/result.h"

namespace roomcast::cli {

/// Seconds. kInvalidArgument: not such a span, or none at all.
[[nodiscard]] Result<std::int64_t> parse_time_span(std::string_view text);

/// In the largest unit that says it well: 90 s is "90s", 7200 s "2h".
[[nodiscard]] std::string format_time_span(std::int64_t seconds);

}  // namespace roomcast::cli
