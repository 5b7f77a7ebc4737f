// SPDX-License-Identifier: Apache-2.0
// Options structs that list their fields once, for checking and for printing. Such a struct has
//   template <class Visit> void for_each_field(Visit visit) const
// which calls `visit(name, value, range)` for every number, duration and array of numbers, and
// `visit(name, options)` for every nested struct of this kind. Thread-safe (no state).
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

#include "roomcast/core/result.h"

namespace roomcast {

/// Legal values of a field; both ends are included.
struct Range {
  double least = 0, most = 0;
};

/// kInvalidArgument unless `value` is in the range: "PlaneOptions.trials must be 1..100000".
[[nodiscard]] Status check_field(std::string_view options, std::string_view field, double value,
                                 Range range);

/// kInvalidArgument unless `value` is at most the field `other`: "FreeSpaceOptions.a must be at
/// most b".
[[nodiscard]] Status check_at_most(std::string_view options, std::string_view field, double value,
                                   std::string_view other, double other_value);

template <class Rep, class Period>
[[nodiscard]] Status check_field(std::string_view options, std::string_view field,
                                 std::chrono::duration<Rep, Period> value, Range range) {
  return check_field(options, field, static_cast<double>(value.count()), range);
}

template <class Number, std::size_t kCount>
[[nodiscard]] Status check_field(std::string_view options, std::string_view field,
                                 const std::array<Number, kCount>& values, Range range) {
  for (const Number value : values) {
    if (Status status = check_field(options, field, double(value), range); !status) return status;
  }
  return {};
}

/// A nested struct checks itself.
template <class Nested>
[[nodiscard]] Status check_field(std::string_view options, std::string_view field,
                                 const Nested& nested) {
  const Status status = nested.check();
  if (status) return {};
  return invalid_argument(std::string(options) + "." + std::string(field) + ": " +
                          status.error().message);
}

/// Checks every field against its range; names the first that is outside. `name`: of the struct.
template <class Options>
[[nodiscard]] Status check_fields(std::string_view name, const Options& options) {
  Status first;
  options.for_each_field([&](std::string_view field, const auto& value, auto... range) {
    if (!first) return;
    if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>) {
      first = check_field(name, field, static_cast<double>(value), range...);
    } else {
      first = check_field(name, field, value, range...);
    }
  });
  return first;
}

}  // namespace roomcast
