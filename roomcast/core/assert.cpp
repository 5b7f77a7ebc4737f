// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/assert.h"

#include <cstdio>
#include <cstdlib>

namespace roomcast {

void assertion_failed(const char* condition, const char* file, int line) noexcept {
  std::fprintf(stderr, "%s:%d: internal error of roomcast: %s is false\n", file, line, condition);
  std::abort();
}

}  // namespace roomcast
