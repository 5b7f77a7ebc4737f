// SPDX-License-Identifier: Apache-2.0
// Decodes untrusted LZFSE: any bytes are refused or give as many bytes as were asked for.
#include <cstddef>
#include <cstdint>

#include "roomcast/recording/lzfse/lzfse.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> out;
  for (const std::size_t wanted : {std::size_t{200}, std::size_t{2400}, std::size_t{24'576}}) {
    const bool decoded = roomcast::recording::decode_lzfse({data, size}, wanted, out);
    if (out.size() > wanted || (decoded && out.size() != wanted)) __builtin_trap();
  }
  return 0;
}
