// SPDX-License-Identifier: Apache-2.0
// Validates UTF-8, for the reason in a close frame. Source: RFC 3629, Unicode table 3-7.
#pragma once

#include <string_view>

namespace roomcast::net {

[[nodiscard]] bool is_utf8(std::string_view text);

}  // namespace roomcast::net
