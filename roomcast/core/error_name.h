// SPDX-License-Identifier: Apache-2.0
// The names of error codes for programs: JSON of the command line, exceptions of Python.
#pragma once

#include <string_view>

#include "roomcast/core/result.h"

namespace roomcast {

[[nodiscard]] constexpr std::string_view name_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kInvalidArgument:
      return "invalid_argument";
    case ErrorCode::kNotFound:
      return "not_found";
    case ErrorCode::kMalformed:
      return "malformed";
    case ErrorCode::kTooLarge:
      return "too_large";
    case ErrorCode::kUnsupported:
      return "unsupported";
    case ErrorCode::kUnavailable:
      return "unavailable";
    case ErrorCode::kClosed:
      break;
  }
  return "closed";
}

}  // namespace roomcast
