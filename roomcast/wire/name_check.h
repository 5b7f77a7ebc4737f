// SPDX-License-Identifier: Apache-2.0
// Names of rooms, sensors and viewers come from untrusted clients and appear in logs, pages and
// error messages.
#pragma once

#include <cstddef>
#include <string_view>

#include "roomcast/core/result.h"

namespace roomcast::wire {

/// Accepts at most `max_bytes` of valid UTF-8 (RFC 3629) without control characters. `what` begins
/// the error sentence. kTooLarge or kMalformed.
[[nodiscard]] Status check_text(std::string_view text, std::size_t max_bytes,
                                std::string_view what);

/// Accepts at most kMaxNameBytes of valid UTF-8 (RFC 3629) without control characters. `what` names
/// the field in the error sentence. kTooLarge or kMalformed.
[[nodiscard]] Status check_name(std::string_view name, std::string_view what);

}  // namespace roomcast::wire
