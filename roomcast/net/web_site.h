// SPDX-License-Identifier: Apache-2.0
// The address of a web site, as a browser's Origin header has it: scheme, name and port. Source:
// RFC 6454. Pure.
#pragma once

#include <string>
#include <string_view>

#include "roomcast/core/result.h"

namespace roomcast::net {

/// "https://Example.org:443" -> "https://example.org". kInvalidArgument: not the address of one
/// site; the sentence shows a right one. The result has no characters that mean something in a
/// Content-Security-Policy.
[[nodiscard]] Result<std::string> parse_web_site(std::string_view text);

}  // namespace roomcast::net
