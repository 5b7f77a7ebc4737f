// SPDX-License-Identifier: Apache-2.0
// The border to C. Functions of roomcast.h use this file to read and write structures of callers
// built against earlier headers, to write error sentences, and to catch exceptions. Threading: no
// state.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <exception>
#include <string>

namespace roomcast::capi {

[[nodiscard]] inline std::string text(const char* string) {
  return string == nullptr ? "" : string;
}

inline void say(const std::string& sentence, char* error, std::size_t size) {
  if (error == nullptr || size == 0) return;
  const std::size_t length = std::min(sentence.size(), size - 1);
  std::memcpy(error, sentence.data(), length);
  error[length] = '\0';
}

/// Catches every exception, std::bad_alloc included, because a C caller cannot handle one. Returns
/// `otherwise` then.
template <class Value, class Call>
Value guarded(Value otherwise, char* error, std::size_t size, Call call) noexcept {
  try {
    return call();
  } catch (const std::exception& problem) {
    say(problem.what(), error, size);
  } catch (...) {
    say("an unknown problem", error, size);
  }
  return otherwise;
}

/// Copies only to.size bytes: a caller built against an earlier header has a smaller structure.
template <class Struct>
void copy_known_part(const Struct& from, Struct& to) {
  const std::size_t size = std::min(to.size, sizeof(Struct));
  Struct copy = from;
  copy.size = to.size;
  std::memcpy(static_cast<void*>(&to), &copy, size);
}

/// `given` may be null. Fields beyond its size, which the caller does not know, are zero.
template <class Struct>
[[nodiscard]] Struct known_part(const Struct* given) {
  Struct known{};
  if (given == nullptr) return known;
  std::memcpy(static_cast<void*>(&known), given, std::min(given->size, sizeof(known)));
  return known;
}

}  // namespace roomcast::capi
