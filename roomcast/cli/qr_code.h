// SPDX-License-Identifier: Apache-2.0
// A QR code for a terminal, two squares a character, dark on light whatever the terminal's colours.
// Source: ISO/IEC 18004, by libqrencode.
#pragma once

#include <string>

#include "roomcast/core/result.h"

namespace roomcast::cli {

/// kTooLarge: no QR code holds so much.
[[nodiscard]] Result<std::string> qr_code_for_terminal(const std::string& text);

}  // namespace roomcast::cli
