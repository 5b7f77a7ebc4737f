// SPDX-License-Identifier: Apache-2.0
// A QR code for a terminal, two modules per character, dark on light in any colour scheme. Source:
// ISO/IEC 18004, by libqrencode.
#pragma once

#include <string>

#include "roomcast/core/result.h"

namespace roomcast::cli {

/// kTooLarge: the text does not fit into a QR code.
[[nodiscard]] Result<std::string> qr_code_for_terminal(const std::string& text);

}  // namespace roomcast::cli
