// SPDX-License-Identifier: Apache-2.0
// Text as a field of a CSV file (RFC 4180). A leading apostrophe keeps spreadsheets from taking a
// text for a formula: names and answers come from strangers. Thread-safe (no state).
#pragma once

#include <string>

namespace roomcast {

/// In quotation marks where it needs them.
[[nodiscard]] std::string csv_field(const std::string& text);

/// Always in quotation marks.
[[nodiscard]] std::string quoted_csv_field(const std::string& text);

}  // namespace roomcast
