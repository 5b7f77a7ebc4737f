// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/random_bytes.h"

#include <cerrno>
#include <cstddef>

#include <sys/random.h>

#include "roomcast/core/assert.h"

namespace roomcast::net {

void fill_with_random_bytes(std::span<std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const auto got = ::getrandom(bytes.data(), bytes.size(), 0);
    ROOMCAST_ASSERT(got > 0 || errno == EINTR);  // on Linux it fails only when misused
    if (got > 0) bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
}

}  // namespace roomcast::net
