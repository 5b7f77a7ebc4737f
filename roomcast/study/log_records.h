// SPDX-License-Identifier: Apache-2.0
// The records of a participant's session log: which kinds there are, and which fields each has,
// with unit and meaning. One table serves the check of what pages send, the columns of exported
// files, and the data dictionary. Threading: immutable.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "roomcast/core/result.h"

namespace roomcast::study {

inline constexpr std::size_t kMaxRecordText = 5000;  // bytes
inline constexpr double kMaxRecordNumber = 1e12;     // of either sign

enum class FieldType { kNumber, kFlag, kText, kAnswer };  // an answer is a number or a text

[[nodiscard]] std::string_view name_of(FieldType type);

struct LogField {
  std::string_view name;
  FieldType type;
  std::string_view unit;  // empty: none
  std::string_view meaning;
};

struct LogKind {
  std::string_view name;  // also of the exported file, without .csv
  std::string_view meaning;
  std::span<const LogField> fields;
};

[[nodiscard]] std::span<const LogKind> log_kinds();
/// Null if there is none of this name.
[[nodiscard]] const LogKind* find_kind(std::string_view name);

/// A record is an object with "kind", "t" (seconds since the session began) and all fields of its
/// kind. kMalformed, with a sentence.
[[nodiscard]] Status check_record(const nlohmann::json& record);

/// The condition that holds after a checked record that begins one, or "" after one that ends one;
/// nothing: the record does neither.
[[nodiscard]] std::optional<std::string> condition_after(const nlohmann::json& record);

}  // namespace roomcast::study
