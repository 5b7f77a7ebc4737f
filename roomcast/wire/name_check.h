// SPDX-License-Identifier: Apache-2.0
// Names of rooms, sensors and viewers come from strangers and end in logs, pages and error
// sentences.
#pragma once

#include <string_view>

#include "roomcast/core/result.h"

namespace roomcast::wire {

/// At most kMaxNameBytes of valid UTF-8 (RFC 3629) without control characters. `what` says whose
/// name it is in the sentence. kTooLarge or kMalformed.
[[nodiscard]] Status check_name(std::string_view name, std::string_view what);

}  // namespace roomcast::wire
