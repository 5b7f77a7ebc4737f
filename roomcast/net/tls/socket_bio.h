// SPDX-License-Identifier: Apache-2.0
// A socket BIO without SIGPIPE: OpenSSL's own raises it when the peer has disconnected.
#pragma once

#include <openssl/types.h>

namespace roomcast::net {

/// A BIO on a non-blocking socket, which stays owned by the caller. Null if out of memory.
[[nodiscard]] BIO* make_socket_bio(int fd);

}  // namespace roomcast::net
