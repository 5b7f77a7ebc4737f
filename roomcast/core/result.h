// SPDX-License-Identifier: Apache-2.0
// Result<T>: a value or an Error, for every operation that depends on the outside world. The
// message is one sentence for the person who has to act on it; it says what to do where that is
// known. Compiles without exceptions (the codec is also built to wasm).
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "roomcast/core/assert.h"

namespace roomcast {

enum class ErrorCode {
  kInvalidArgument,  // the caller or user passed an invalid value
  kNotFound,         // a file, sensor or host does not exist
  kMalformed,        // bytes from outside do not follow their format
  kTooLarge,         // a stated limit is exceeded
  kUnsupported,      // well-formed, but from another version or kind
  kUnavailable,      // may work later: connection lost, port in use
  kClosed,           // closed in good order by either side
};

struct Error {
  ErrorCode code = ErrorCode::kInvalidArgument;
  std::string message;
};

[[nodiscard]] inline Error invalid_argument(std::string sentence) {
  return {ErrorCode::kInvalidArgument, std::move(sentence)};
}
[[nodiscard]] inline Error malformed(std::string sentence) {
  return {ErrorCode::kMalformed, std::move(sentence)};
}
[[nodiscard]] inline Error unavailable(std::string sentence) {
  return {ErrorCode::kUnavailable, std::move(sentence)};
}

/// A value of type T or an Error. `T` may be `void` (see Status).
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}      // NOLINT: implicit
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & { return *checked(std::get_if<0>(&state_)); }
  const T& value() const& { return *checked(std::get_if<0>(&state_)); }
  T&& value() && { return std::move(*checked(std::get_if<0>(&state_))); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Error& error() const& { return *checked(std::get_if<1>(&state_)); }
  Error&& error() && { return std::move(*checked(std::get_if<1>(&state_))); }

 private:
  template <class P>
  static P* checked(P* pointer) {
    ROOMCAST_ASSERT(pointer != nullptr);
    return pointer;
  }
  std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)), ok_(false) {}  // NOLINT: implicit

  [[nodiscard]] bool ok() const { return ok_; }
  explicit operator bool() const { return ok_; }
  const Error& error() const& {
    ROOMCAST_ASSERT(!ok_);
    return error_;
  }
  Error&& error() && {
    ROOMCAST_ASSERT(!ok_);
    return std::move(error_);
  }

 private:
  Error error_;
  bool ok_ = true;
};

/// Success, or the reason for the failure.
using Status = Result<void>;

}  // namespace roomcast
