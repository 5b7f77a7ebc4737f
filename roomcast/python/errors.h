// SPDX-License-Identifier: Apache-2.0
// Errors at the border to Python: a Result that failed becomes the exception roomcast.Error, with
// the project's sentence as its text and the kind of error as its `code`. Threading: no state.
#pragma once

#include <exception>
#include <utility>

#include <pybind11/pybind11.h>

#include "roomcast/core/result.h"

namespace roomcast::python {

/// Becomes roomcast.Error in Python.
class Failure final : public std::exception {
 public:
  explicit Failure(Error error) : error_(std::move(error)) {}
  [[nodiscard]] const char* what() const noexcept override { return error_.message.c_str(); }
  [[nodiscard]] const Error& error() const { return error_; }

 private:
  Error error_;
};

/// The value, or throws Failure.
template <class Value>
[[nodiscard]] Value value_of(Result<Value> result) {
  if (!result) throw Failure(std::move(result).error());
  return std::move(result).value();
}
inline void check(const Status& status) {
  if (!status) throw Failure(status.error());
}

/// Adds `Error` to the module and translates Failure into it.
void add_error(pybind11::module_& module);

}  // namespace roomcast::python
