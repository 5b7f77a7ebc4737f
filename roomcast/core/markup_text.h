// SPDX-License-Identifier: Apache-2.0
// Text within HTML and SVG, where names come from strangers. Thread-safe (no state).
#pragma once

#include <string>

namespace roomcast {

/// With entities for & < > and quotation marks: nothing in it is taken for markup, nor for the end
/// of an attribute in quotation marks.
[[nodiscard]] std::string markup_text(const std::string& text);

}  // namespace roomcast
