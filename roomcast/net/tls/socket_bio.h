// SPDX-License-Identifier: Apache-2.0
// OpenSSL's own socket BIO raises SIGPIPE when the peer is gone; this one never does.
#pragma once

#include <openssl/types.h>

namespace roomcast::net {

/// A BIO on a non-blocking socket that stays its owner's. Null when memory is out.
[[nodiscard]] BIO* make_socket_bio(int fd);

}  // namespace roomcast::net
