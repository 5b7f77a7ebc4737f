// SPDX-License-Identifier: Apache-2.0
// VpxContext: a libvpx encoder or decoder, destroyed if it was opened. Single-threaded.
#pragma once

#include <vpx/vpx_codec.h>

namespace roomcast::codec {

struct VpxContext {
  vpx_codec_ctx_t context{};
  bool open = false;
  VpxContext() = default;
  VpxContext(const VpxContext&) = delete;
  VpxContext& operator=(const VpxContext&) = delete;
  ~VpxContext() {
    if (open) vpx_codec_destroy(&context);
  }
};

}  // namespace roomcast::codec
